#include "colmap_ext/import/imported_scene.h"

#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/import_test_base.h"
#include "colmap_ext/import/measurement_distortion.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

ImportedScene SceneOf(const SparseModel& model) {
  ImportedScene scene;
  for (const ModelImage& image : model.images) {
    scene.images.push_back(
        {image.name, model.CameraOf(image), image.cam_from_world, image.observations, "a.txt"});
  }
  scene.points = model.points;
  return scene;
}

TEST(ImportedScene, IntegerCentersMoveEverythingByHalfAPixel) {
  const SparseModel known = CenteredModel();
  SparseModelOptions options;
  options.pixel_centers = PixelCenters::kInteger;
  const SparseModel model = ToSparseModel(SceneOf(known), options);
  EXPECT_EQ(model.cameras[0].params, (std::vector<double>{600.25, 320.5, 240.5}));
  EXPECT_EQ(model.images[0].observations[0].position,
            known.images[0].observations[0].position + Eigen::Vector2d(0.5, 0.5));
}

TEST(ImportedScene, SimilarCamerasAreSharedIfAsked) {
  ImportedScene scene = SceneOf(KnownModel());
  scene.images[1].camera.params[0] += 0.05;  // 0.026 px at the border
  scene.images[2].camera.params[3] += 0.04;
  SparseModelOptions options;
  EXPECT_EQ(ToSparseModel(scene, options).cameras.size(), 3u);
  options.share_cameras_px = 0.03;
  EXPECT_EQ(ToSparseModel(scene, options).cameras.size(), 2u);
  options.share_cameras_px = 0.041;
  const SparseModel model = ToSparseModel(scene, options);
  ASSERT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].params, KnownModel().cameras[0].params);
}

TEST(ImportedScene, WhatNoModelMayHoldIsRefused) {
  ImportedScene scene = SceneOf(KnownModel());
  scene.images[2].number = 7;
  const auto error = [&] { return ErrorText<IoError>([&] { ToSparseModel(scene, {}); }); };
  scene.images[2].name = "img_1.png";
  EXPECT_THAT(error(), HasSubstr("a.txt: line 7: image 3: image name \"img_1.png\" occurs twice"));
  scene.images[2].name = "img_10.png";
  scene.images[2].cam_from_world.translation.x() = NAN;
  EXPECT_THAT(error(), HasSubstr("a.txt: line 7: image 3 (img_10.png): the pose is not finite"));
}

TEST(Calibration, SkewIsDroppedOnlyIfNegligible) {
  const std::string path = "k.txt";
  const Place place{path, "line", 3};
  Eigen::Matrix3d k;
  k << 600, 0.1, 320, 0, 500, 240, 0, 0, 1;
  EXPECT_EQ(CameraFromCalibration(2 * k, {640, 480}, place).params,
            (std::vector<double>{600, 500, 320, 240}));
  k(0, 1) = -0.11;
  EXPECT_THAT(ErrorText<IoError>([&] {
                CameraFromCalibration(k, {640, 480}, place);
              }),
              HasSubstr("k.txt: line 3: the pixels are skewed: 0.0528 px"));
}

TEST(Calibration, ARotationWithFewDigitsIsMadeOne) {
  const std::string path = "r.txt";
  const Place place{path, "line", 1};
  const Eigen::Matrix3d exact =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d rounded = (exact * 1e4).array().round() / 1e4;
  const Eigen::Matrix3d rotation = RotationFromMatrix(rounded, place).toRotationMatrix();
  EXPECT_LT((rotation - exact).norm(), 3e-4);
  EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

// The bound that is told is kept, and is tiny for lenses as they are found.
TEST(MeasurementDistortion, IsInverted) {
  for (const double r : {0.3, 0.1, -0.05}) {
    const auto inverted = InvertMeasurementDistortion(r, 0.6);
    ASSERT_TRUE(inverted.has_value());
    EXPECT_LT(inverted->max_error, 1e-6) << r;
    const std::vector<double>& k = inverted->extra;
    for (double m = 0.05; m < 0.6; m += 0.05) {
      const double p = m * (1 + r * m * m);
      const double u = p * p;
      const double factor =
          (1 + u * (k[0] + u * (k[1] + u * k[4]))) / (1 + u * (k[5] + u * (k[6] + u * k[7])));
      EXPECT_NEAR(p * factor, m, 1.01 * inverted->max_error + 1e-15) << r;
    }
  }
  EXPECT_FALSE(InvertMeasurementDistortion(-1, 0.6).has_value());
}

}  // namespace
}  // namespace limn::colmap_ext
