// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/imported_scene.h"

#include "colmap_ext/import/import_test_base.h"
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

}  // namespace
}  // namespace limn::colmap_ext
