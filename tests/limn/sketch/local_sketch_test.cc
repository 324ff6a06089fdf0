// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/local_sketch.h"

#include <optional>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Confirmation views at these angles beside the primary one, around the origin. With the last one
// left out, support is narrow.
constexpr double kAnglesOfViewsDeg[] = {-10, 5, 12, 35};
constexpr uint32_t kNarrow = 0b0111;
constexpr uint32_t kWide = 0b1110;
constexpr uint32_t kAll = 0b1111;

class VerdictTest : public ::testing::Test {
 protected:
  VerdictTest() {
    views_.push_back(testing::RingView(0, 5));
    for (const double degrees : kAnglesOfViewsDeg) {
      plan_.confirmation_views.push_back(static_cast<ViewId>(views_.size()));
      views_.push_back(testing::RingView(degrees, 5));
    }
  }

  // Of a sample at the origin.
  PrimaryView::Verdict Judge(uint32_t contained, uint32_t supporting, double weighted) const {
    const SketchEdgels edgels(views_.size());
    const SketchInput input = {{views_, curves_, hints_, box_}};
    const PrimaryView primary(input, 0, plan_, edgels, options_);
    HypothesisSupport support;
    support.contained = {contained};
    support.supporting = {supporting};
    support.weighted = {weighted};
    return primary.Judge(support, 0, views_[0].cam_from_world * Eigen::Vector3d::Zero());
  }

  std::vector<View> views_;
  ViewPlan plan_;
  SketchOptions options_;
  std::optional<Eigen::AlignedBox3d> box_;
  const std::vector<ImageCurves> curves_ = std::vector<ImageCurves>(5);
  const SceneHints hints_;
};

TEST_F(VerdictTest, SupportedByEnoughViewsAndCertainByEnoughWeight) {
  EXPECT_FALSE(Judge(kAll, 0b1100, 3).supported);
  EXPECT_TRUE(Judge(kAll, kWide, 2.9).supported);
  EXPECT_FALSE(Judge(kAll, kWide, 2.9).certain);
  EXPECT_TRUE(Judge(kAll, kWide, 3).certain);
}

TEST_F(VerdictTest, NarrowSupportIsNoneIfAWideViewContainsTheSample) {
  EXPECT_FALSE(Judge(kAll, kNarrow, 3).supported);
  EXPECT_TRUE(Judge(kNarrow, kNarrow, 3).supported);
}

TEST_F(VerdictTest, ByWeightAloneSupportsWhatIsCertainAtAnyAngles) {
  options_.by_weight_alone = true;
  EXPECT_TRUE(Judge(kAll, kNarrow, 3).supported);
  EXPECT_TRUE(Judge(kAll, kNarrow, 3).certain);
  EXPECT_FALSE(Judge(kAll, kWide, 2.9).supported);
  EXPECT_FALSE(Judge(kAll, kWide, 2.9).certain);
  EXPECT_FALSE(Judge(kAll, 0b1100, 3).supported);
}

// Views of one panorama are at one place.
TEST(ForScene, ScenesOfFewPlacesNeedAllOfThem) {
  std::vector<View> views;
  const auto required = [&](int min_views) {
    SketchOptions options;
    options.min_supporting_views = min_views;
    return ForScene(options, views).min_supporting_views;
  };
  for (const double degrees : {0, 0, 20, 40, 40}) views.push_back(testing::RingView(degrees, 5));
  EXPECT_EQ(required(1), 1);
  EXPECT_EQ(required(2), 2);
  EXPECT_EQ(required(3), 2);
  views.push_back(testing::RingView(60, 5));
  EXPECT_EQ(required(3), 3);
  EXPECT_EQ(required(6), 3);
  for (int i = 0; i < 10; ++i) views.push_back(testing::RingView(70 + 10 * i, 5));
  EXPECT_EQ(required(6), 6);
}

TEST_F(VerdictTest, NothingOutsideOfTheBoxIsSupported) {
  for (const bool by_weight_alone : {false, true}) {
    options_.by_weight_alone = by_weight_alone;
    box_ = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
    EXPECT_TRUE(Judge(kAll, kWide, 3).supported);
    box_ = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, 0.1), Eigen::Vector3d(1, 1, 1));
    EXPECT_FALSE(Judge(kAll, kWide, 3).supported);
  }
}

}  // namespace
}  // namespace limn
