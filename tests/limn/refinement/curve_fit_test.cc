// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/curve_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/refinement/edgel_matches.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr int kNumViews = 8;
// About the width of a pixel at the origin.
constexpr double kPx = 5.0 / 600;

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(kNumViews, 5);
  return views;
}

// Along x.
const testing::SceneCurve& Edge() {
  static const auto edge = testing::Segment({-0.4, 0, 0}, {0.4, 0, 0});
  return edge;
}

class CurveFitTest : public ::testing::Test {
 protected:
  NodeId AddNode(const Eigen::Vector3d& position) {
    graph_.nodes.emplace_back();
    graph_.nodes.back().position_in_world = position;
    return static_cast<NodeId>(graph_.nodes.size()) - 1;
  }

  void AddLink(NodeId node0, NodeId node1) {
    DrawingLink link;
    link.node0 = node0;
    link.node1 = node1;
    for (const NodeId node : {node0, node1}) {
      link.points_in_world.push_back(graph_.nodes[node].position_in_world);
    }
    link.sigma.assign(2, kPx);
    for (int v = 0; v < kNumViews; ++v) link.supporting_views.push_back(v);
    graph_.links.push_back(link);
    RebuildIncidence(&graph_);
  }

  // The control points, fitted to what the images show.
  ControlGraph Fit(const std::vector<ImageCurves>& curves, const std::vector<bool>& frozen) {
    const auto edgels = BuildViewEdgels(curves, {});
    ControlGraph control = MakeControlGraph(graph_, Views(), options_.control_spacing_px);
    before_ = control.position;
    const SupportGate gate = {options_.max_distance_px, 1.0, options_.max_angle_deg * kDeg};
    MatchEdgels({Views(), curves, edgels, gate}, options_, {}, &control);
    for (size_t l = 0; l < frozen.size(); ++l) control.links[l].frozen = frozen[l];
    FitCurves(Views(), options_, {}, false, &control);
    return control;
  }

  // Largest distance of the points of a link from the x axis, px.
  static double FarthestPx(const ControlGraph& control, int link) {
    double farthest = 0;
    for (const int point : control.links[link].points) {
      farthest = std::max(farthest, control.position[point].tail<2>().norm() / kPx);
    }
    return farthest;
  }

  DrawingGraph graph_;
  RefinementOptions options_;
  std::vector<Eigen::Vector3d> before_;
};

TEST_F(CurveFitTest, ALinkGoesToItsEdgels) {
  AddLink(AddNode({-0.25, 0.5 * kPx, 0}), AddNode({0.25, 0.5 * kPx, 0}));
  const ControlGraph fitted = Fit(testing::ProjectCurves(Views(), {Edge()}), {false});
  // Edgels are exact; what holds the points weighs next to nothing.
  EXPECT_LT(FarthestPx(fitted, 0), 0.01);
}

TEST_F(CurveFitTest, AViewThatErrsHardlyCounts) {
  AddLink(AddNode({-0.25, 0, 0}), AddNode({0.25, 0, 0}));
  std::vector<ImageCurves> curves = testing::ProjectCurves(Views(), {Edge()});
  for (Edgel& edgel : curves[0].edge_map.edgels) edgel.position_px += 0.9 * edgel.Normal();
  const double robust_px = FarthestPx(Fit(curves, {false}), 0);
  options_.robust_residual_px = 100;
  const double plain_px = FarthestPx(Fit(curves, {false}), 0);
  // By Cauchy's weight, 1 / (1 + (0.9 / 0.5)^2) = 0.24 of what it would.
  EXPECT_GT(plain_px, 0.05);
  EXPECT_LT(robust_px, 0.4 * plain_px);
}

TEST_F(CurveFitTest, SmallerBendingSigmaIsSmoother) {
  AddLink(AddNode({-0.25, 0, 0}), AddNode({0.25, 0, 0}));
  const std::vector<ImageCurves> noisy = testing::ProjectCurves(Views(), {Edge()}, 0.3);
  // Largest distance of a point from the middle of its neighbors, px.
  const auto roughness_px = [&](const ControlGraph& control) {
    double largest = 0;
    for (const auto& bend : control.bends) {
      const Eigen::Vector3d middle = 0.5 * (control.position[bend[0]] + control.position[bend[2]]);
      const Eigen::Vector3d offset = control.position[bend[1]] - middle;
      largest = std::max(largest, offset.tail<2>().norm() / kPx);
    }
    return largest;
  };
  options_.bending_sigma = 1e-4;
  const double smooth_px = roughness_px(Fit(noisy, {false}));
  options_.bending_sigma = 1e3;
  const double rough_px = roughness_px(Fit(noisy, {false}));
  // Each point is known to about the noise over the root of its edgels.
  EXPECT_GT(rough_px, 0.03);
  EXPECT_LT(smooth_px, 0.003);
}

TEST_F(CurveFitTest, FrozenLinksFollowTheirNodes) {
  const NodeId shared = AddNode({0.25, 0.5 * kPx, 0});
  AddLink(AddNode({-0.25, 0.5 * kPx, 0}), shared);
  AddLink(shared, AddNode({0.25, 0.3, 0}));
  const ControlGraph fitted = Fit(testing::ProjectCurves(Views(), {Edge()}), {false, true});
  const Eigen::Vector3d moved = fitted.position[shared] - before_[shared];
  EXPECT_GT(moved.norm(), 0.3 * kPx);
  const std::vector<int>& points = fitted.links[1].points;
  const double last = static_cast<double>(points.size()) - 1;
  for (size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3d expected =
        before_[points[k]] + (1 - static_cast<double>(k) / last) * moved;
    EXPECT_LT((fitted.position[points[k]] - expected).norm(), 1e-12) << "point " << k;
  }
}

}  // namespace
}  // namespace limn
