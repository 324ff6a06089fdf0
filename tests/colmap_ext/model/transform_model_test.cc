// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/transform_model.h"

#include <sstream>

#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"

namespace limn::colmap_ext {
namespace {

const Similarity3d& WorldOfTest() {
  static const Similarity3d world = {
      3.5,
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(2, -1, 3).normalized()).toRotationMatrix(),
      {4e5, -20, 5e6}};
  return world;
}

// MakeModel with a rig of its cameras, and a frame per image.
SparseModel MountedModel() {
  SparseModel model = MakeModel();
  Rigid3d second_from_rig;
  second_from_rig.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
  second_from_rig.translation = {0.2, 0.1, -0.05};
  model.rigs = {{1, {{{0, 3}, true, {}}, {{0, 7}, true, second_from_rig}, {{1, 5}, false, {}}}}};
  for (const ModelImage& image : model.images) {
    const bool is_second = image.camera_id == 7;
    const Rigid3d rig_from_world =
        is_second ? Inverse(second_from_rig) * image.cam_from_world : image.cam_from_world;
    model.frames.push_back({image.id, 1, rig_from_world, {{{0, image.camera_id}, image.id}}});
  }
  return model;
}

std::string BytesOf(SparseModel model) {
  for (ModelImage& image : model.images) image.cam_from_world = {};
  for (ModelPoint& point : model.points) point.position.setZero();
  for (Frame& frame : model.frames) frame.rig_from_world = {};
  for (Rig& rig : model.rigs) {
    for (RigSensor& sensor : rig.sensors) sensor.sensor_from_rig.translation.setZero();
  }
  std::ostringstream bytes;
  for (const ModelFile& file : kBinaryModelFiles) file.write(model, bytes);
  return bytes.str();
}

TEST(TransformModel, CamerasSeeTheSamePixels) {
  const SparseModel before = MakeModel();
  SparseModel after = before;
  TransformModel(WorldOfTest(), &after);
  for (size_t i = 0; i < before.images.size(); ++i) {
    const Rigid3d& old_pose = before.images[i].cam_from_world;
    const Rigid3d& new_pose = after.images[i].cam_from_world;
    EXPECT_LT(
        (Inverse(new_pose).translation - WorldOfTest() * Inverse(old_pose).translation).norm(),
        1e-8);
    for (size_t p = 0; p < before.points.size(); ++p) {
      const Eigen::Vector3d old_place = old_pose * before.points[p].position;
      const Eigen::Vector3d new_place = new_pose * after.points[p].position;
      EXPECT_LT((new_place - WorldOfTest().scale * old_place).norm(), 1e-7);
    }
  }
  for (size_t p = 0; p < before.points.size(); ++p) {
    EXPECT_EQ(after.points[p].position, WorldOfTest() * before.points[p].position);
  }
}

TEST(TransformModel, PosesOfRigsGoWithThoseOfImages) {
  SparseModel model = MountedModel();
  TransformModel(WorldOfTest(), &model);
  for (size_t i = 0; i < model.images.size(); ++i) {
    const ModelImage& image = model.images[i];
    const Rigid3d sensor_from_rig = model.rigs[0].sensors[image.camera_id == 7].sensor_from_rig;
    const Rigid3d composed = sensor_from_rig * model.frames[i].rig_from_world;
    EXPECT_LT(composed.rotation.angularDistance(image.cam_from_world.rotation), 1e-7);
    EXPECT_LT((composed.translation - image.cam_from_world.translation).norm(), 1e-8);
  }
  EXPECT_EQ(model.rigs[0].sensors[1].sensor_from_rig.translation,
            WorldOfTest().scale * Eigen::Vector3d(0.2, 0.1, -0.05));
}

TEST(TransformModel, AllElseStays) {
  SparseModel model = MountedModel();
  const std::string before = BytesOf(model);
  TransformModel(WorldOfTest(), &model);
  EXPECT_EQ(BytesOf(model), before);
}

}  // namespace
}  // namespace limn::colmap_ext
