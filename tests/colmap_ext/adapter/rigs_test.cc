// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include <gtest/gtest.h>

#include "colmap_ext/adapter/colmap_versions.h"
#include "colmap_ext/model/mounted_images.h"

namespace limn::colmap_ext {
namespace {

// Rigs and frames as COLMAP 3.12 and later have them, whichever version is linked.
enum class SensorType { kCamera = 0, kImu = 1 };
struct Sensor {
  SensorType type;
  uint32_t id;
  auto operator<=>(const Sensor&) const = default;
};
struct Datum {
  Sensor sensor_id;
  uint32_t id;
};
struct StandInRig {
  uint32_t id;
  Sensor reference;
  std::map<Sensor, std::optional<Rigid3d>> others;
  uint32_t RigId() const { return id; }
  size_t NumSensors() const { return 1 + others.size(); }
  const Sensor& RefSensorId() const { return reference; }
  const auto& NonRefSensors() const { return others; }
};
struct StandInFrame {
  uint32_t id;
  uint32_t rig;
  std::optional<Rigid3d> pose;
  std::vector<Datum> data;
  uint32_t FrameId() const { return id; }
  uint32_t RigId() const { return rig; }
  bool HasPose() const { return pose.has_value(); }
  const Rigid3d& RigFromWorld() const { return *pose; }
  const auto& DataIds() const { return data; }
};
struct StandIn {
  std::unordered_map<uint32_t, StandInRig> rigs;
  std::unordered_map<uint32_t, StandInFrame> frames;
  const auto& Rigs() const { return rigs; }
  const auto& Frames() const { return frames; }
};

Rigid3d Shifted(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0, 0)}; }

TEST(ColmapRigs, GiveThePosesOfTheirImages) {
  const Sensor left{SensorType::kCamera, 4}, right{SensorType::kCamera, 5};
  const Sensor imu{SensorType::kImu, 4};
  StandIn reconstruction;
  reconstruction.rigs[2] = {2, left, {{right, Shifted(-0.1)}, {imu, std::nullopt}}};
  reconstruction.rigs[1] = {1, left, {}};
  reconstruction.frames[9] = {9, 2, Shifted(3), {{left, 70}, {right, 71}, {imu, 70}}};
  reconstruction.frames[8] = {8, 2, std::nullopt, {{left, 72}}};

  SparseModel model;
  AddColmapRigs(reconstruction, &model);

  ASSERT_EQ(model.rigs.size(), 2u);
  EXPECT_EQ(model.rigs[0].id, 1u);
  EXPECT_EQ(model.rigs[1].NumCameras(), 2);
  EXPECT_EQ(model.rigs[1].sensors[0].sensor, (SensorId{kCameraSensor, 4}));
  ASSERT_EQ(model.frames.size(), 1u) << "the other frame has no pose";
  model.images.resize(3);
  for (int i = 0; i < 3; ++i) {
    model.images[i].id = 70 + i;
    model.images[i].camera_id = i == 1 ? 5 : 4;
  }
  const std::vector<MountedImage> mounted = MountedImages(model);
  ASSERT_EQ(mounted.size(), 2u);
  EXPECT_DOUBLE_EQ(ComposedPose(model, mounted[0]).translation.x(), 3);
  EXPECT_DOUBLE_EQ(ComposedPose(model, mounted[1]).translation.x(), 2.9);
}

}  // namespace
}  // namespace limn::colmap_ext
