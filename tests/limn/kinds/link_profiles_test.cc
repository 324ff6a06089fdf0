// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/link_profiles.h"

#include <gtest/gtest.h>

#include "limn/kinds/step_image.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using testing::FrontalViews;
using testing::kFrontalPx;

DrawingGraph LineOfPx(double length_px, int num_views) {
  DrawingGraph graph;
  graph.nodes.resize(2);
  DrawingLink link;
  link.points_in_world = {FrontalPoint(0, -length_px / 2), FrontalPoint(0, length_px / 2)};
  link.sigma = {0, 0};
  link.node0 = 0;
  link.node1 = 1;
  for (int node = 0; node < 2; ++node) {
    graph.nodes[node].position_in_world = link.points_in_world[node];
  }
  for (ViewId view = 0; view < num_views; ++view) link.supporting_views.push_back(view);
  graph.links.push_back(link);
  RebuildIncidence(&graph);
  EXPECT_TRUE(Validate(graph).empty());
  return graph;
}

TEST(PlanProfilesTest, PlacesAreSixPxApartAndAtMostThirtyTwo) {
  const std::vector<View> views = FrontalViews(2, 1, 0.1);
  const ProfilePlan plan = PlanProfiles(LineOfPx(60.6, 2), views);
  ASSERT_EQ(plan.places[0].size(), 10u);
  for (size_t k = 1; k < plan.places[0].size(); ++k) {
    const Eigen::Vector3d step =
        plan.places[0][k].position_in_world - plan.places[0][k - 1].position_in_world;
    EXPECT_NEAR(step.norm(), 6.06 * kFrontalPx, 1e-9);
    EXPECT_NEAR(plan.places[0][k].tangent.y(), 1, 1e-9);
  }
  EXPECT_EQ(PlanProfiles(LineOfPx(300, 2), views).places[0].size(), 32u);
  EXPECT_EQ(PlanProfiles(LineOfPx(2, 2), views).places[0].size(), 1u);
}

TEST(PlanProfilesTest, ManyViewsAreThinnedEvenly) {
  const std::vector<View> views = FrontalViews(48, 1, 0.01);
  const ProfilePlan plan = PlanProfiles(LineOfPx(40, 48), views);
  int num_views = 0;
  for (size_t v = 0; v < views.size(); ++v) {
    const bool is_measured = !plan.links_of_view[v].empty();
    EXPECT_EQ(is_measured, v % 2 == 0);
    num_views += is_measured;
  }
  EXPECT_EQ(num_views, 24);
}

TEST(MeasureProfilesTest, ProfilesAreThoseOfTheViewAtTheProjections) {
  const View view = FrontalViews(1, 1, 1)[0];
  const DrawingGraph graph = LineOfPx(60, 1);
  const ProfilePlan plan = PlanProfiles(graph, {view});
  const double x0 = view.Project(FrontalPoint(0, 0))->x();
  const Image image = testing::ImageOf(640, 480, [&](double x, double) {
    return testing::Mix({30, 30, 30}, {130, 130, 130}, testing::GaussianStep((x - x0) / 1.2));
  });
  const std::vector<LinkProfile> profiles = MeasureProfiles(view, image, plan, {0});
  ASSERT_EQ(profiles.size(), plan.places[0].size());
  for (const LinkProfile& profile : profiles) {
    EXPECT_EQ(profile.link, 0);
    EXPECT_NEAR(profile.depth, 5, 1e-5);
    // Interpolation, differences and the end of the step: edge_profile_test.cc.
    EXPECT_NEAR(profile.profile.width_px, 0.97 * std::sqrt(1.44 + 0.25), 0.1);
  }
}

}  // namespace
}  // namespace limn
