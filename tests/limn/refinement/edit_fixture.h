#pragma once

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "limn/model/graph_fixture.h"
#include "limn/refinement/topology_edits.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// Points of the plane that all views look down on, px.
using PxLine = std::vector<Eigen::Vector2d>;

inline Polyline3d InWorld(const PxLine& line) {
  Polyline3d points;
  for (const Eigen::Vector2d& point : line) points.push_back(FrontalPoint(point.x(), point.y()));
  return points;
}

inline Eigen::Vector2d Unit(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

// The line from a point in a direction.
inline PxLine Ray(const Eigen::Vector2d& from, double angle_rad, double length_px) {
  return {from, from + length_px * Unit(angle_rad)};
}

// An arc from the origin, which it leaves along the x axis, turning left.
inline PxLine Arc(double radius_px, double turn_rad) {
  PxLine arc;
  const int count = static_cast<int>(std::ceil(4 * radius_px * turn_rad));
  for (int k = 0; k <= count; ++k) {
    const double angle = turn_rad * k / count;
    arc.emplace_back(radius_px * std::sin(angle), radius_px * (1 - std::cos(angle)));
  }
  return arc;
}

// A drawing on that plane, what the images show, and an edit of its topology.
class EditScene {
 public:
  static const std::vector<View>& Views() {
    static const std::vector<View> views = FrontalViews(4, 2, 0.75);
    return views;
  }
  static std::vector<ViewId> FirstViews(size_t count) {
    std::vector<ViewId> views(count);
    std::iota(views.begin(), views.end(), 0);
    return views;
  }

  // A line that returns to its first point is closed. All views support it unless some are given.
  LinkId Draw(const PxLine& line, const std::vector<ViewId>& views = FirstViews(Views().size())) {
    frozen_.push_back(0);
    return DrawLink(InWorld(line), views, &graph);
  }
  void Freeze(LinkId link) { frozen_[link] = 1; }

  // Edgels run along this line in the views given.
  void Show(const PxLine& line, const std::vector<ViewId>& views = FirstViews(Views().size())) {
    for (const ViewId view : views) shown_[view].push_back({InWorld(line), false});
  }

  template <typename Edit>
  auto Run(Edit&& edit) {
    std::vector<std::unique_ptr<EdgelIndex>> edgels;
    std::vector<ImageCurves> curves;
    for (size_t v = 0; v < Views().size(); ++v) {
      curves.push_back(ProjectCurves(Views()[v], shown_[v]));
      edgels.push_back(
          std::make_unique<EdgelIndex>(curves.back().edge_map, LinkedEdgels(curves.back())));
    }
    GraphEditor editor(Views(), edgels, options, frozen_, &graph);
    const auto result = edit(&editor);
    ExpectValid(graph);
    return result;
  }

  int64_t Trim() { return Run(TrimEnds); }
  int64_t Join() { return Run(JoinAlignedEnds); }
  int64_t SplitCorners() { return Run(SplitAtCorners); }
  SnapCounts Snap() { return Run(SnapEnds); }

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

  RefinementOptions options;
  DrawingGraph graph;

 private:
  std::vector<uint8_t> frozen_;
  std::vector<std::vector<SceneCurve>> shown_ =
      std::vector<std::vector<SceneCurve>>(Views().size());
};

}  // namespace limn::testing
