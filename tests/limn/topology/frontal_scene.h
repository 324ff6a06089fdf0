// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/topology/coinciding_places.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/frontal_lines.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/grow_edges.h"
#include "limn/topology/join_ends.h"
#include "limn/topology/joint_rays.h"
#include "limn/topology/snap_ends.h"
#include "limn/topology/split_corners.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// Links on the plane that frontal views look down on, what the images of frontal views show, and an
// edit of the topology. Links get a point about every px; their vertices have the edgels that are
// shown along them.
class FrontalScene {
 public:
  explicit FrontalScene(int cols = 4, int rows = 4)
      : views_(FrontalViews(cols, rows, 0.75)), shown_(views_.size()) {}

  const std::vector<View>& views() const { return views_; }
  std::vector<ViewId> Views(ViewId begin, ViewId end) const {
    std::vector<ViewId> ids(end - begin);
    std::iota(ids.begin(), ids.end(), begin);
    return ids;
  }
  std::vector<ViewId> AllViews() const { return Views(0, static_cast<ViewId>(views_.size())); }

  // Edgels run along this line in the views given, or in all.
  void ShowInSpace(const Polyline3d& edge, const std::vector<ViewId>& in_views) {
    for (const ViewId v : in_views) shown_[v].push_back({edge, false});
  }
  void ShowInSpace(const Polyline3d& edge) { ShowInSpace(edge, AllViews()); }
  void Show(const PxLine& line, const std::vector<ViewId>& in_views) {
    ShowInSpace(InWorld(line), in_views);
  }
  void Show(const PxLine& line) { Show(line, AllViews()); }

  // A link, made from the edgels along it in these views, or in all. A line that returns to its
  // first point is closed; ends at the same place share a node.
  LinkId Draw(const PxLine& line, const std::vector<ViewId>& views) {
    return AddDrawn(InWorld(line), InWorld(line), views);
  }
  LinkId Draw(const PxLine& line) { return Draw(line, AllViews()); }
  // An edge that was drawn.
  void ShowAndDraw(const PxLine& line, const std::vector<ViewId>& views) {
    Show(line, views);
    Draw(line, views);
  }
  void ShowAndDraw(const PxLine& line) { ShowAndDraw(line, AllViews()); }
  // A link that was made from the edgels along another straight line.
  void DrawFromEdgelsOf(const PxLine& edge, const Polyline3d& line) {
    AddDrawn(line, InWorld(edge), AllViews());
  }
  // A link without vertices.
  void Freeze(LinkId link) { drawn_[link].frozen = true; }

  template <typename Edit>
  auto Run(Edit&& edit) {
    Build();
    GraphEditor editor(&graph);
    const auto result = edit(Input(), &editor);
    ExpectValid(graph);
    return result;
  }

  int64_t Trim() {
    return Run([&](const auto&, GraphEditor* editor) { return TrimEnds(options, editor); });
  }
  int64_t SplitCorners() {
    return Run([](const auto&, GraphEditor* editor) { return SplitAtCorners(editor); });
  }
  // Within the reach of links fitted to the images.
  int64_t JoinFacing() {
    return Run([&](const auto& input, GraphEditor* editor) {
      MeetingCounts counts;
      JoinFacingEnds({input, options, Reach::Fitted(options), editor, &counts});
      return counts.joined;
    });
  }
  // Continuations are paired afterwards.
  MeetingCounts Snap() {
    return Run([&](const auto& input, GraphEditor* editor) {
      MeetingCounts counts;
      SnapEnds({input, options, Reach::Fitted(options), editor, &counts});
      PairContinuations(options, &graph);
      return counts;
    });
  }
  // Continuations are paired afterwards.
  CoincidenceCounts Unite() {
    return Run([&](const auto& input, GraphEditor* editor) {
      MeetingCounts counts;
      const CoincidenceCounts united =
          UniteCoincidingPlaces({input, options, Reach::Fitted(options), editor, &counts});
      PairContinuations(options, &graph);
      return united;
    });
  }
  RepairCounts Repair() {
    Build();
    const RepairCounts counts = RepairTopology(Input(), options, {}, &graph);
    ExpectValid(graph);
    return counts;
  }
  // The links added by growth, as polylines from their joint.
  std::vector<Polyline3d> Grow(const std::optional<Eigen::AlignedBox3d>& box = std::nullopt,
                               GrowthEnd ends = GrowthEnd::kAnywhere) {
    return Run([&](TopologyInput input, GraphEditor* editor) {
      input.box = box;
      const auto before = graph.links.size();
      return Added(before, GrowEdges(input, options, ends, {}, editor));
    });
  }
  std::vector<Polyline3d> AddShort() {
    return Run([&](const auto& input, GraphEditor* editor) {
      const auto before = graph.links.size();
      return Added(before, AddShortEdges(input, options, {}, editor));
    });
  }

  // Give links their vertices; edits do it by themselves.
  void Build() {
    if (built_) return;
    built_ = true;
    for (size_t v = 0; v < views_.size(); ++v) {
      curves_.push_back(ProjectCurves(views_[v], shown_[v]));
    }
    edgels_ = BuildViewEdgels(curves_, {});
    for (size_t l = 0; l < drawn_.size(); ++l) {
      if (!drawn_[l].frozen) GiveVertices(static_cast<LinkId>(l));
    }
    ExpectValid(graph);
  }
  TopologyInput Input() const { return {views_, curves_, edgels_, {1.0, 1.0, M_PI / 12}}; }

  // The joint at a place; fails if there is not exactly one.
  Joint JointAt(const Eigen::Vector3d& place) {
    Build();
    std::vector<Joint> found = CollectJoints(graph, views_.size());
    std::erase_if(found, [&](const Joint& joint) {
      return (joint.position - place).norm() > 0.01 * kFrontalPx;
    });
    EXPECT_EQ(found.size(), 1u) << place.transpose() / kFrontalPx;
    return found.empty() ? Joint() : found.front();
  }
  // A direction in which image edges leave the joint at a place.
  std::optional<JointDirection> DirectionAt(const Eigen::Vector3d& place, size_t min_views) {
    Build();
    return FindJointDirection(Input(), JointAt(place), min_views);
  }

  double LengthPx(LinkId link) const {
    return Length(graph.links[link].points_in_world) / kFrontalPx;
  }
  double TotalPx() const {
    double sum = 0;
    for (size_t l = 0; l < graph.links.size(); ++l) sum += LengthPx(static_cast<LinkId>(l));
    return sum;
  }
  int Degree(double x_px, double y_px, double max_px = 1e-6) const {
    return DegreeAt(graph, FrontalPoint(x_px, y_px), max_px * kFrontalPx);
  }
  const DrawingNode& Node(double x_px, double y_px, double max_px = 1e-6) const {
    return graph.nodes.at(NodeAtPlace(graph, FrontalPoint(x_px, y_px), max_px * kFrontalPx));
  }

  TopologyOptions options;
  DrawingGraph graph;

 private:
  struct Drawn {
    Polyline3d edge;  // whose edgels it is made from
    std::vector<ViewId> views;
    bool frozen = false;
  };

  LinkId AddDrawn(const Polyline3d& line, const Polyline3d& edge,
                  const std::vector<ViewId>& views) {
    drawn_.push_back({edge, views});
    return DrawLink(line, views, &graph);
  }

  void GiveVertices(LinkId id) {
    DrawingLink& link = graph.links[id];
    const bool on_edge = drawn_[id].edge.size() != 2 || drawn_[id].edge == link.points_in_world;
    const Polyline3d ends = {link.points_in_world.front(), link.points_in_world.back()};
    link.points_in_world = ResampleUniform(link.points_in_world, kFrontalPx);
    link.points_in_world.front() = ends.front();
    link.points_in_world.back() = ends.back();
    link.sigma.assign(link.points_in_world.size(), 1);
    const Polyline3d& edge = drawn_[id].edge;
    for (int k = 0; k < link.size(); ++k) {
      const double share = static_cast<double>(k) / (link.size() - 1);
      const Eigen::Vector3d place = on_edge
                                        ? link.points_in_world[k]
                                        : Eigen::Vector3d((1 - share) * edge[0] + share * edge[1]);
      const Eigen::Vector3d along = on_edge ? TangentAt(link, k) : (edge[1] - edge[0]).normalized();
      LinkVertex vertex;
      vertex.footprint = kFrontalPx;
      vertex.support = SupportAt(Input(), place, along, drawn_[id].views, Input().gate);
      vertex.samples = {{id, k}};
      link.vertices.push_back(std::move(vertex));
    }
  }

  std::vector<Polyline3d> Added(size_t before, int64_t count) const {
    EXPECT_EQ(graph.links.size(), before + count);
    std::vector<Polyline3d> added;
    for (size_t l = before; l < graph.links.size(); ++l) {
      added.push_back(graph.links[l].points_in_world);
    }
    return added;
  }

  std::vector<View> views_;
  std::vector<std::vector<SceneCurve>> shown_;
  std::vector<Drawn> drawn_;
  bool built_ = false;
  std::vector<ImageCurves> curves_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
};

// A straight line, px.
inline PxLine PxSegment(double from_x, double from_y, double to_x, double to_y) {
  return {{from_x, from_y}, {to_x, to_y}};
}

}  // namespace limn::testing
