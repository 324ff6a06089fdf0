// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_scene.h"

#include <memory>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "limn/model/lens_map.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Stored pixels are virtual ones, moved.
class ShiftLens : public LensMap {
 public:
  explicit ShiftLens(double shift_px) : shift_px_(shift_px, 0) {}
  std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const override {
    return Eigen::Vector2d(stored_px - shift_px_);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    return Eigen::Vector2d(virtual_px + shift_px_);
  }

 private:
  const Eigen::Vector2d shift_px_;
};

CameraScene SceneOf(std::shared_ptr<const LensMap> given, const std::vector<View>& views) {
  CameraScene scene;
  scene.views = views;
  for (View& view : scene.views) view.lens = given;
  scene.given = scene.views;
  return scene;
}

class CurvesSeenNowTest : public ::testing::Test {
 protected:
  CurvesSeenNowTest()
      : views_(testing::DomeViews(1, 5)),
        curves_(testing::ProjectCurves(views_, {testing::Segment({-0.5, 0, 0}, {0.5, 0, 0})})) {}

  static void SetLens(std::shared_ptr<const LensMap> lens, CameraScene* scene) {
    scene->views[0].lens = std::move(lens);
  }
  static double FirstX(const std::vector<ImageCurves>& curves) {
    return curves[0].edge_map.edgels[0].position_px.x();
  }

  const std::vector<View> views_;
  const std::vector<ImageCurves> curves_;
};

TEST_F(CurvesSeenNowTest, GivenCamerasSeeThemAsTheyAre) {
  PictureLevel level = {1, curves_};
  const CameraScene scene = SceneOf(std::make_shared<ShiftLens>(2), views_);
  EXPECT_EQ(&CurvesSeenNow(scene, {}, &level), &level.curves);
}

TEST_F(CurvesSeenNowTest, OtherLensesMapThemOnceAndAgainWhenTheyChange) {
  PictureLevel level = {1, curves_};
  CameraScene scene = SceneOf(nullptr, views_);
  const double given_x = FirstX(level.curves);
  SetLens(std::make_shared<ShiftLens>(2), &scene);
  EXPECT_NEAR(FirstX(CurvesSeenNow(scene, {}, &level)), given_x - 2, 1e-3);
  const Edgel* first = level.seen[0].edge_map.edgels.data();
  EXPECT_EQ(CurvesSeenNow(scene, {}, &level)[0].edge_map.edgels.data(), first);
  SetLens(std::make_shared<ShiftLens>(5), &scene);
  EXPECT_NEAR(FirstX(CurvesSeenNow(scene, {}, &level)), given_x - 5, 1e-3);
  SetLens(nullptr, &scene);
  EXPECT_EQ(&CurvesSeenNow(scene, {}, &level), &level.curves);
  EXPECT_EQ(FirstX(level.curves), given_x);
  EXPECT_TRUE(level.seen.empty());
}

TEST_F(CurvesSeenNowTest, SmallPicturesAreKeptAsStored) {
  PictureLevel level = {2, curves_};
  CameraScene scene = SceneOf(nullptr, views_);
  EXPECT_EQ(&CurvesSeenNow(scene, {}, &level), &level.curves);
  // The given lens, too, maps them: by half as many of their pixels.
  scene = SceneOf(std::make_shared<ShiftLens>(4), views_);
  EXPECT_NEAR(FirstX(CurvesSeenNow(scene, {}, &level)), FirstX(level.curves) - 2, 1e-3);
}

}  // namespace
}  // namespace limn
