#include "limn/support/link_footprint.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

constexpr double kFocal = 600;

// A view on the x axis that looks at the origin from this depth.
View ViewFrom(double depth) { return testing::LookAt({depth, 0, 0}, Vector3d::Zero()); }

// A view that has the origin behind it.
View TurnedAway() { return testing::LookAt({5, 0, 0}, {10, 0, 0}); }

DrawingLink LinkSeenBy(const std::vector<ViewId>& views) {
  DrawingLink link;
  link.supporting_views = views;
  return link;
}

TEST(LinkFootprintTest, IsTheMedianOverTheSupportingViews) {
  const std::vector<View> views = {ViewFrom(40), ViewFrom(9),  ViewFrom(2), ViewFrom(30),
                                   ViewFrom(3),  ViewFrom(50), ViewFrom(60)};
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({1, 2, 4}), Vector3d::Zero(), views), 3 / kFocal, 1e-12);
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({5}), Vector3d::Zero(), views), 50 / kFocal, 1e-12);
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({0, 1, 2, 3, 4}), Vector3d::Zero(), views), 9 / kFocal,
              1e-12);
}

TEST(LinkFootprintTest, IsThatOfThePoint) {
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({0}), {1, 0.3, -0.2}, {ViewFrom(5)}), 4 / kFocal, 1e-12);
}

TEST(LinkFootprintTest, SupportingViewsThatHaveThePointBehindThemDoNotCount) {
  const std::vector<View> views = {TurnedAway(), ViewFrom(3), TurnedAway(), ViewFrom(40),
                                   ViewFrom(50)};
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({0, 1, 2}), Vector3d::Zero(), views), 3 / kFocal, 1e-12);
}

TEST(LinkFootprintTest, WithoutSupportingViewsThatSeeItIsTheMedianOverAll) {
  const std::vector<View> views = {ViewFrom(8), TurnedAway(), ViewFrom(2), ViewFrom(4)};
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({}), Vector3d::Zero(), views), 4 / kFocal, 1e-12);
  EXPECT_NEAR(LinkFootprint(LinkSeenBy({1}), Vector3d::Zero(), views), 4 / kFocal, 1e-12);
}

TEST(LinkFootprintTest, IsZeroWhereNoViewSeesThePoint) {
  EXPECT_EQ(LinkFootprint(LinkSeenBy({0}), Vector3d::Zero(), {TurnedAway(), TurnedAway()}), 0);
  EXPECT_EQ(LinkFootprint(LinkSeenBy({}), Vector3d::Zero(), {}), 0);
}

}  // namespace
}  // namespace limn
