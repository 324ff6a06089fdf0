#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/drawing/corner_edges.h"
#include "limn/drawing/corner_rays.h"
#include "limn/drawing/joints.h"
#include "limn/geometry/polyline.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// What tests of the late stages of the drawing know of links on their way into the graph: all else
// is in terms of polylines. samples[k] are merged into point k.
inline void AppendLink(const Polyline3d& points, double footprint,
                       const std::vector<std::vector<int>>& samples, Draft* draft) {
  DraftLink link;
  link.position = points;
  link.information.assign(points.size(), Eigen::Matrix3d::Identity());
  link.footprint.assign(points.size(), footprint);
  link.samples = samples;
  draft->links.push_back(std::move(link));
}

// Links drawn so far and what the images of frontal views show: what grows from it?
class GrowthScene {
 public:
  explicit GrowthScene(int cols = 4, int rows = 4)
      : views_(FrontalViews(cols, rows, 0.75)), shown_(views_.size()) {}

  const std::vector<View>& views() const { return views_; }
  std::vector<ViewId> Views(ViewId begin, ViewId end) const {
    std::vector<ViewId> ids(end - begin);
    std::iota(ids.begin(), ids.end(), begin);
    return ids;
  }
  std::vector<ViewId> AllViews() const { return Views(0, static_cast<ViewId>(views_.size())); }

  void Show(const Polyline3d& edge, const std::vector<ViewId>& in_views) {
    for (const ViewId v : in_views) shown_[v].push_back({edge, false});
  }
  void Show(const Polyline3d& edge) { Show(edge, AllViews()); }
  // A link that is drawn, made from the edgels along it in these views. Ends within 2 px of each
  // other share a node.
  void Draw(const Polyline3d& line, const std::vector<ViewId>& views) {
    drawn_.push_back({line, line, views});
  }
  void Draw(const Polyline3d& line) { Draw(line, AllViews()); }
  // Both: an edge that was drawn.
  void ShowAndDraw(const Polyline3d& line) { ShowAndDraw(line, AllViews()); }
  void ShowAndDraw(const Polyline3d& line, const std::vector<ViewId>& views) {
    Show(line, views);
    Draw(line, views);
  }
  // A link that was made from the edgels along another line.
  void DrawFromEdgelsOf(const Polyline3d& edge, const Polyline3d& line) {
    drawn_.push_back({line, edge, AllViews()});
  }

  // The links added by growth, as polylines from their joint.
  std::vector<Polyline3d> Grow(const std::optional<Eigen::AlignedBox3d>& box = std::nullopt) {
    Build();
    const EdgelEvidence edgels = IndexEdgels(curves_, evidence_, samples_, draft_);
    return Added(GrowCornerEdges(views_, curves_, edgels, box, options, {}, &samples_, &draft_));
  }
  std::vector<Polyline3d> AddShort() {
    Build();
    const EdgelEvidence edgels = IndexEdgels(curves_, evidence_, samples_, draft_);
    return Added(AddShortEdges(views_, curves_, edgels, options, {}, &samples_, &draft_));
  }
  // The joint at a place; fails if there is not exactly one.
  Joint JointAt(const Eigen::Vector3d& place) {
    if (draft_.links.empty()) Build();
    std::vector<Joint> found = CollectJoints(samples_, views_.size(), draft_);
    std::erase_if(found, [&](const Joint& joint) {
      return (joint.position - place).norm() > 0.01 * kFrontalPx;
    });
    EXPECT_EQ(found.size(), 1u) << place.transpose() / kFrontalPx;
    return found.empty() ? Joint() : found.front();
  }
  // After Grow, AddShort or JointAt: ends that share a node at a place; 0 at a free end.
  int EndsAt(const Eigen::Vector3d& place) {
    const Joint joint = JointAt(place);
    return joint.ends.size() < 2 ? 0 : static_cast<int>(joint.ends.size());
  }
  // A direction in which image edges leave the joint at a place.
  std::optional<CornerDirection> DirectionAt(const Eigen::Vector3d& place, int min_views) {
    Build();
    const EdgelEvidence edgels = IndexEdgels(curves_, evidence_, samples_, draft_);
    return FindCornerDirection(JointAt(place), views_, curves_, edgels.all, min_views);
  }

  DrawingOptions options;

 private:
  struct Drawn {
    Polyline3d line;
    Polyline3d edge;  // whose edgels it is made from
    std::vector<ViewId> views;
  };

  void Build() {
    curves_.clear();
    for (size_t v = 0; v < views_.size(); ++v) {
      curves_.push_back(ProjectCurves(views_[v], shown_[v]));
    }
    evidence_ = BuildEvidence(curves_, {});
    samples_ = SampleSet();
    draft_ = Draft();
    for (const Drawn& drawn : drawn_) AddDrawn(drawn);
    draft_.num_sketch_samples = samples_.NumSamples();
    ShareNodes();
  }

  void AddDrawn(const Drawn& drawn) {
    EdgelIndexes edgels;
    for (const auto& of_view : evidence_) edgels.push_back(&of_view->edgels);
    const Polyline3d points = ResampleUniform(drawn.line, 2 * kFrontalPx);
    std::vector<std::vector<int>> merged;
    samples_.origins.push_back({});
    for (size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d tangent =
          (points[std::min(k + 1, points.size() - 1)] - points[k > 0 ? k - 1 : 0]).normalized();
      merged.push_back({samples_.NumSamples()});
      samples_.curve_of.push_back(samples_.NumCurves() - 1);
      samples_.position.push_back(points[k]);
      samples_.tangent.push_back(tangent);
      samples_.information.push_back(Eigen::Matrix3d::Identity() - tangent * tangent.transpose());
      samples_.footprint.push_back(kFrontalPx);
      const double share = static_cast<double>(k) / static_cast<double>(points.size() - 1);
      const Polyline3d edge =
          CutPolyline(drawn.edge, 0, std::max(share * Length(drawn.edge), 1e-6));
      const Eigen::Vector3d along = (edge.back() - edge[edge.size() - 2]).normalized();
      samples_.support.Append(
          SupportAt(edge.back(), along, drawn.views, views_, edgels, options.Gate()));
    }
    samples_.curve_begin.push_back(samples_.NumSamples());
    AppendLink(points, kFrontalPx, merged, &draft_);
  }

  void ShareNodes() {
    std::vector<std::pair<LinkEnd, Eigen::Vector3d>> ends;
    for (size_t l = 0; l < draft_.links.size(); ++l) {
      const auto id = static_cast<LinkId>(l);
      ends.push_back({{id, 0}, draft_.links[l].position.front()});
      ends.push_back({{id, 1}, draft_.links[l].position.back()});
    }
    for (size_t i = 0; i < ends.size(); ++i) {
      int& node = draft_.links[ends[i].first.link].node[ends[i].first.end];
      for (size_t j = i + 1; j < ends.size(); ++j) {
        if ((ends[i].second - ends[j].second).norm() > 2 * kFrontalPx) continue;
        if (node < 0) node = draft_.num_nodes++;
        draft_.links[ends[j].first.link].node[ends[j].first.end] = node;
      }
    }
  }

  std::vector<Polyline3d> Added(int64_t count) const {
    EXPECT_EQ(draft_.links.size(), drawn_.size() + count);
    std::vector<Polyline3d> added;
    for (size_t l = drawn_.size(); l < draft_.links.size(); ++l) {
      added.push_back(draft_.links[l].position);
    }
    return added;
  }

  std::vector<View> views_;
  std::vector<std::vector<SceneCurve>> shown_;
  std::vector<Drawn> drawn_;
  std::vector<ImageCurves> curves_;
  std::vector<std::unique_ptr<ViewEvidence>> evidence_;
  SampleSet samples_;
  Draft draft_;
};

// A straight line on the plane that frontal views look down on, px.
inline Polyline3d PxSegment(double from_x, double from_y, double to_x, double to_y) {
  return {FrontalPoint(from_x, from_y), FrontalPoint(to_x, to_y)};
}

}  // namespace limn::testing
