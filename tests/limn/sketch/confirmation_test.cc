// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/confirmation.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/sketch/tangency.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Cameras in the plane z = 0, 5 away from the origin: the primary one, and others at these angles
// beside it.
constexpr double kAnglesDeg[] = {-20, -10, 12, 25};
constexpr uint32_t kAllViews = 0b1111;
constexpr ViewId kFirstOther = 1;
// The width of a pixel at the origin.
constexpr double kPx = 5.0 / 600;

class ConfirmationTest : public ::testing::Test {
 protected:
  ConfirmationTest() {
    views_.push_back(testing::RingView(0, 5));
    for (const double degrees : kAnglesDeg) {
      views_.push_back(testing::RingView(degrees, 5));
    }
  }

  // What the other views say to `curve` at `scale` times its true depth when they show `seen`.
  HypothesisSupport Confirm(const testing::SceneCurve& curve, const testing::SceneCurve& seen,
                            double scale = 1, ViewId second = kNoView) const {
    std::vector<std::unique_ptr<OrientationMask>> masks;
    for (const View& view : views_) {
      const ImageCurves image = testing::ProjectCurves(view, {seen});
      masks.push_back(std::make_unique<OrientationMask>(image.edge_map, LinkedEdgels(image),
                                                        view.region, options_.Gate()));
    }
    const ImageCurves primary = testing::ProjectCurves(views_[0], {curve});
    const FragmentRays fragment = MakeFragmentRays(views_[0], primary, 0);
    // Parallel to the image plane: one depth.
    const Eigen::Vector3d first = views_[0].cam_from_world * curve.points.front();
    const Eigen::Vector3d last = views_[0].cam_from_world * curve.points.back();
    CurveHypothesis hypothesis;
    for (size_t i = 0; i < fragment.size(); ++i) {
      HypothesisSample sample;
      sample.vertex = static_cast<int>(i);
      sample.depth = scale * first.z();
      sample.tangent_in_cam = (last - first).normalized();
      hypothesis.samples.push_back(sample);
    }
    const ConfirmationViews others(0, {1, 2, 3, 4}, views_, masks);
    return others.Confirm(fragment, hypothesis, second).value();
  }

  const testing::SceneCurve upright_ = testing::Segment({0, 0, -0.4}, {0, 0, 0.4});
  const SketchOptions options_;
  std::vector<View> views_;
};

TEST_F(ConfirmationTest, ATrueCurveIsSupportedEverywhere) {
  const HypothesisSupport support = Confirm(upright_, upright_);
  for (size_t j = 0; j < support.supporting.size(); ++j) {
    EXPECT_EQ(support.contained[j], kAllViews);
    EXPECT_EQ(support.supporting[j], kAllViews) << "sample " << j;
  }
}

TEST_F(ConfirmationTest, AWrongDepthIsNotSupported) {
  const HypothesisSupport support = Confirm(upright_, upright_, 1.1);
  for (size_t j = 0; j < support.supporting.size(); ++j) {
    EXPECT_EQ(support.supporting[j], 0u);
    EXPECT_EQ(support.weighted[j], 0);
  }
}

TEST_F(ConfirmationTest, TheSecondViewDoesNotConfirmItself) {
  const HypothesisSupport support = Confirm(upright_, upright_, 1, kFirstOther + 2);
  for (const uint32_t views : support.supporting) EXPECT_EQ(views, kAllViews & ~0b0100u);
}

TEST_F(ConfirmationTest, AFewEdgelsAreNoSupport) {
  // A dash of 1.5 px: with 1 px more to either side far less than the share asked for of 9 px.
  const auto dash = testing::Segment({0, 0, -0.75 * kPx}, {0, 0, 0.75 * kPx});
  const HypothesisSupport support = Confirm(upright_, dash);
  EXPECT_TRUE(std::any_of(support.inliers.begin(), support.inliers.end(),
                          [](uint32_t views) { return views == kAllViews; }));
  for (const uint32_t views : support.supporting) EXPECT_EQ(views, 0u);
}

TEST_F(ConfirmationTest, ACurveAlongTheEpipolarLinesCountsLittle) {
  // In the plane of all cameras: supported at any depth.
  const auto lying = testing::Segment({0, -0.4, 0}, {0, 0.4, 0});
  const HypothesisSupport along = Confirm(lying, lying);
  const HypothesisSupport across = Confirm(upright_, upright_);
  const size_t middle = along.weighted.size() / 2;
  EXPECT_EQ(along.supporting[middle], kAllViews);
  EXPECT_NEAR(along.weighted[middle], 4 * kMinTangencyWeight, 1e-9);
  EXPECT_NEAR(across.weighted[across.weighted.size() / 2], 4, 1e-9);
}

TEST_F(ConfirmationTest, MotionIsThatOfTheImage) {
  // How much a change of inverse depth moves the projections, on average.
  const Eigen::Vector3d point = views_[0].cam_from_world * Eigen::Vector3d::Zero();
  const double step = 1e-6;
  double moved_px = 0;
  for (size_t v = 1; v < views_.size(); ++v) {
    const Rigid3d to_other = views_[v].cam_from_world * Inverse(views_[0].cam_from_world);
    const Eigen::Vector3d further = point / (1 + step * point.z());
    const View& view = views_[v];
    moved_px +=
        (view.camera.Project(to_other * further) - view.camera.Project(to_other * point)).norm() /
        4;
  }
  const HypothesisSupport support = Confirm(upright_, upright_);
  const double motion = support.px_per_inverse_depth[support.px_per_inverse_depth.size() / 2];
  EXPECT_NEAR(motion, moved_px / step, 1e-3 * motion);
}

TEST_F(ConfirmationTest, LargestAngleIsOfTheViewsAskedFor) {
  const std::vector<std::unique_ptr<OrientationMask>> masks(views_.size());
  const ConfirmationViews others(0, {1, 2, 3, 4}, views_, masks);
  const Eigen::Vector3d point = views_[0].cam_from_world * Eigen::Vector3d::Zero();
  EXPECT_NEAR(others.MaxAngleDeg(point, kAllViews), 25, 1e-9);
  EXPECT_NEAR(others.MaxAngleDeg(point, 0b0110), 12, 1e-9);
  EXPECT_EQ(others.MaxAngleDeg(point, 0), 0);
}

}  // namespace
}  // namespace limn
