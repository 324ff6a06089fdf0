// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/scene_origin.h"

#include <gtest/gtest.h>

#include "colmap_ext/model/test_model.h"

namespace limn::colmap_ext {
namespace {

const Eigen::Vector3d kFar(5e5, 4e6, 100);

TEST(SceneOrigin, IsZeroForModelsNearTheirOrigin) {
  EXPECT_EQ(SceneOrigin(MakeModel()), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(SceneOrigin({}), Eigen::Vector3d(0, 0, 0));
}

TEST(SceneOrigin, IsAmidTheCamerasOfAGeoReferencedModel) {
  SparseModel model = MakeModel();
  MoveModel(kFar, &model);
  const Eigen::Vector3d origin = SceneOrigin(model);
  MoveModel(-origin, &model);
  for (const ModelImage& image : model.images) {
    EXPECT_LT(Inverse(image.cam_from_world).translation.norm(), 10);
  }
  EXPECT_EQ(SceneOrigin(model), Eigen::Vector3d(0, 0, 0));
}

// Cameras some units apart.
TEST(SceneOrigin, HasRoundCoordinates) {
  SparseModel model = MakeModel();
  MoveModel(kFar + Eigen::Vector3d(0.123456789, 0.7, 1.0 / 3), &model);
  const Eigen::Vector3d origin = SceneOrigin(model);
  EXPECT_EQ(origin, (origin.array() * 10).round().matrix() / 10);
}

TEST(SceneOrigin, CamerasAtOneCenterStayWhereTheyAre) {
  SparseModel model = MakeModel();
  for (ModelImage& image : model.images) {
    image.cam_from_world.translation = -(image.cam_from_world.rotation * kFar);
  }
  EXPECT_EQ(SceneOrigin(model), Eigen::Vector3d(0, 0, 0));
}

TEST(MoveModel, MovesCentersAndPoints) {
  const SparseModel before = MakeModel();
  SparseModel after = before;
  MoveModel(kFar, &after);
  for (size_t i = 0; i < before.images.size(); ++i) {
    const Eigen::Vector3d moved = Inverse(after.images[i].cam_from_world).translation -
                                  Inverse(before.images[i].cam_from_world).translation;
    EXPECT_LT((moved - kFar).norm(), 1e-8);
  }
  for (size_t i = 0; i < before.points.size(); ++i) {
    EXPECT_EQ(after.points[i].position, before.points[i].position + kFar);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
