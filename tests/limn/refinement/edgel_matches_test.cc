// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/edgel_matches.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/support/edgel_residual.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr int kNumMatchViews = 8;
// About the width of a pixel at the origin.
constexpr double kOnePx = 5.0 / 600;

// From both sides of the x axis at several elevations: all see it at full length.
const std::vector<View>& ViewsAround() {
  static const std::vector<View> views = [] {
    std::vector<View> all;
    for (const double side : {-5.0, 5.0}) {
      for (const double degrees : {20.0, 35.0, 50.0, 65.0}) {
        const double elevation = degrees * kDeg;
        all.push_back(
            testing::LookAt({0, side * std::cos(elevation), 5 * std::sin(elevation)}, {0, 0, 0}));
      }
    }
    return all;
  }();
  return views;
}

// Along x, longer than the links that are matched with it.
const testing::SceneCurve& EdgelAt() {
  static const auto edge = testing::Segment({-0.4, 0, 0}, {0.4, 0, 0});
  return edge;
}

class EdgelMatchesTest : public ::testing::Test {
 protected:
  EdgelMatchesTest() : curves_(testing::ProjectCurves(ViewsAround(), {EdgelAt()})) {}

  // A link parallel to the edge, of which all views are asked.
  void AddLink(const Eigen::Vector3d& offset) {
    DrawingLink link;
    for (const double x : {-0.25, 0.25}) {
      link.points_in_world.push_back(offset + Eigen::Vector3d(x, 0, 0));
      graph_.nodes.emplace_back();
      graph_.nodes.back().position_in_world = link.points_in_world.back();
    }
    link.sigma.assign(2, kOnePx);
    link.node0 = static_cast<NodeId>(graph_.nodes.size()) - 2;
    link.node1 = link.node0 + 1;
    for (int v = 0; v < kNumMatchViews; ++v) link.supporting_views.push_back(v);
    graph_.links.push_back(link);
    RebuildIncidence(&graph_);
  }

  void Match() {
    const auto edgels = BuildViewEdgels(curves_, {});
    control_ = MakeControlGraph(graph_, ViewsAround(), options_.control_spacing_px);
    const SupportGate gate = {options_.max_distance_px, 1.0, options_.max_angle_deg * kDeg};
    MatchEdgels({ViewsAround(), curves_, edgels, gate}, options_, {}, &control_);
  }

  const std::vector<FitSample>& MatchFirst() {
    Match();
    return control_.links[0].samples;
  }

  // Of the first link.
  Eigen::Vector3d PositionOf(const FitSample& sample) const {
    const std::vector<int>& points = control_.links[0].points;
    return (1 - sample.t) * control_.position[points[sample.segment]] +
           sample.t * control_.position[points[sample.segment + 1]];
  }

  static bool Pulls(ViewId view, const FitSample& sample) {
    return std::any_of(sample.pulls.begin(), sample.pulls.end(),
                       [&](const EdgelPull& pull) { return pull.ref.view == view; });
  }
  static bool PullsAnywhere(ViewId view, const std::vector<FitSample>& matches) {
    return std::any_of(matches.begin(), matches.end(),
                       [&](const FitSample& sample) { return Pulls(view, sample); });
  }

  // What one view shows instead.
  void Show(ViewId view, const testing::SceneCurve& curve) {
    curves_[view] = testing::ProjectCurves(ViewsAround()[view], {curve});
  }
  // In one view the other side of the edge is the brighter one.
  void SwapSides(ViewId view) {
    for (Edgel& edgel : curves_[view].edge_map.edgels) {
      edgel.tangent_rad = std::remainder(edgel.tangent_rad + M_PI, 2 * M_PI);
    }
  }

  std::vector<ImageCurves> curves_;
  DrawingGraph graph_;
  RefinementOptions options_;
  ControlGraph control_;
};

TEST_F(EdgelMatchesTest, EveryViewThatShowsTheLinkPullsOnce) {
  AddLink({0, 0, 0});
  const std::vector<FitSample> matches = MatchFirst();
  EXPECT_GT(matches.size(), 15u);
  for (const FitSample& sample : matches) {
    ASSERT_EQ(sample.pulls.size(), static_cast<size_t>(kNumMatchViews));
    for (int v = 0; v < kNumMatchViews; ++v) {
      EXPECT_EQ(sample.pulls[v].ref.view, v);
      EXPECT_NEAR(sample.pulls[v].residual_px, 0, 1e-5);
    }
  }
}

TEST_F(EdgelMatchesTest, TooFewViewsPullNot) {
  AddLink({0, 0, 0});
  graph_.links[0].supporting_views = {0, 3};
  for (const FitSample& sample : MatchFirst()) EXPECT_TRUE(sample.pulls.empty());
  options_.min_views = 2;
  for (const FitSample& sample : MatchFirst()) EXPECT_EQ(sample.pulls.size(), 2u);
}

TEST_F(EdgelMatchesTest, AViewThatShowsADashOnlyIsNotHeard) {
  AddLink({0, 0, 0});
  // 2 px of the 12 around it, and one more at either side within the gate.
  Show(0, testing::Segment({-kOnePx, 0, 0}, {kOnePx, 0, 0}));
  // A stretch of 24 px shows the link in its middle.
  Show(1, testing::Segment({-12 * kOnePx, 0, 0}, {12 * kOnePx, 0, 0}));
  const std::vector<FitSample> matches = MatchFirst();
  EXPECT_FALSE(PullsAnywhere(0, matches));
  EXPECT_TRUE(Pulls(1, matches[matches.size() / 2]));
  EXPECT_FALSE(Pulls(1, matches.front()));
}

TEST_F(EdgelMatchesTest, TheOtherSideOfABarIsAnotherEdge) {
  AddLink({0, 0, 0});
  SwapSides(0);
  const std::vector<FitSample> matches = MatchFirst();
  for (const FitSample& sample : matches) {
    EXPECT_EQ(sample.pulls.size(), static_cast<size_t>(kNumMatchViews) - 1);
    EXPECT_FALSE(Pulls(0, sample));
  }
}

TEST_F(EdgelMatchesTest, WhereViewsDoNotAgreeOnTheSideAllAreHeard) {
  AddLink({0, 0, 0});
  for (int v = 0; v < kNumMatchViews / 2; ++v) SwapSides(v);
  for (const FitSample& sample : MatchFirst()) {
    EXPECT_EQ(sample.pulls.size(), static_cast<size_t>(kNumMatchViews));
  }
}

TEST_F(EdgelMatchesTest, ViewsInWhichAnotherLinkRunsBesideAreNotHeard) {
  AddLink({0, 0, 0});
  // Behind the first one as view 0 sees it.
  const Eigen::Vector3d ray = -ViewsAround()[0].CenterInWorld().normalized();
  const Eigen::Vector3d behind = 12 * kOnePx * ray;
  AddLink(behind);
  const std::vector<FitSample> matches = MatchFirst();
  const FitSample& sample = matches[matches.size() / 2];
  const Eigen::Vector3d position = PositionOf(sample);
  int num_apart = 0;
  for (int v = 0; v < kNumMatchViews; ++v) {
    const Eigen::Vector2d here = *ViewsAround()[v].Project(position);
    const Eigen::Vector2d ahead = *ViewsAround()[v].Project(position + Eigen::Vector3d(0.01, 0, 0));
    const Eigen::Vector2d other = *ViewsAround()[v].Project(position + behind);
    const Eigen::Vector2d along = (ahead - here).normalized();
    const Eigen::Vector2d offset = other - here;
    const double apart_px = std::abs(along.x() * offset.y() - along.y() * offset.x());
    if (apart_px > 2.5 && apart_px < 3.5) continue;
    EXPECT_EQ(Pulls(v, sample), apart_px > 3) << "view " << v << ": " << apart_px << " px";
    num_apart += apart_px > 3;
  }
  EXPECT_GE(num_apart, options_.min_views);
  EXPECT_FALSE(Pulls(0, sample));
}

TEST_F(EdgelMatchesTest, AnEdgelBelongsToTheLinkThatFitsItBetter) {
  AddLink({0, 0, 0});
  AddLink({0, 0.6 * kOnePx, 0});
  Match();
  for (const FitSample& sample : control_.links[0].samples) {
    EXPECT_EQ(sample.pulls.size(), static_cast<size_t>(kNumMatchViews));
  }
  for (const FitSample& sample : control_.links[1].samples) {
    // Alike to a tenth of a pixel is the same.
    for (const EdgelPull& pull : sample.pulls) EXPECT_LE(std::abs(pull.residual_px), 0.1 + 1e-5);
  }
}

TEST_F(EdgelMatchesTest, WeightIsTheStepOverTheLengthOfAnErrorAndTheVariance) {
  AddLink({0, 0, 0});
  const std::vector<FitSample> matches = MatchFirst();
  for (size_t k = 0; k + 1 < matches.size(); ++k) {
    for (const EdgelPull& pull : matches[k].pulls) {
      const View& view = ViewsAround()[pull.ref.view];
      const Eigen::Vector2d step =
          *view.Project(PositionOf(matches[k + 1])) - *view.Project(PositionOf(matches[k]));
      const Edgel& edgel = curves_[pull.ref.view].edge_map.edgels[pull.ref.edgel];
      EXPECT_NEAR(pull.weight * ResidualVariance(edgel), step.norm() / options_.correlation_px,
                  1e-9);
    }
  }
}

}  // namespace
}  // namespace limn
