// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/rig.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/mounted_images.h"
#include "colmap_ext/model/rig_files.h"
#include "colmap_ext/model/rig_fit.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kRigsText[] =
    "# rigs\n"
    "1 3 CAMERA 3 CAMERA 7 1 1 0 0 0 0.5 0 0 IMU 9 1 1 0 0 0 0 0 0\n"
    "2 2 CAMERA 20 CAMERA 21 0\n";
constexpr char kFramesText[] =
    "6 1 1 0 0 0 1 2 3 3 CAMERA 3 9 CAMERA 7 4 IMU 9 50\n"
    "7 1 1 0 0 0 4 5 6 1 CAMERA 3 5\n";

template <typename T>
std::string Bytes(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof(T));
}

std::string PoseBytes(double x, double y, double z) {
  std::string bytes;
  for (const double value : {1.0, 0.0, 0.0, 0.0, x, y, z}) bytes += Bytes(value);
  return bytes;
}

std::string SensorBytes(int32_t type, uint32_t id) { return Bytes(type) + Bytes(id); }

// The same as the text above.
std::string RigsBinary() {
  return Bytes<uint64_t>(2) + Bytes<uint32_t>(1) + Bytes<uint32_t>(3) + SensorBytes(0, 3) +
         SensorBytes(0, 7) + Bytes<uint8_t>(1) + PoseBytes(0.5, 0, 0) + SensorBytes(1, 9) +
         Bytes<uint8_t>(1) + PoseBytes(0, 0, 0) + Bytes<uint32_t>(2) + Bytes<uint32_t>(2) +
         SensorBytes(0, 20) + SensorBytes(0, 21) + Bytes<uint8_t>(0);
}

std::string FramesBinary() {
  return Bytes<uint64_t>(2) + Bytes<uint32_t>(6) + Bytes<uint32_t>(1) + PoseBytes(1, 2, 3) +
         Bytes<uint32_t>(3) + SensorBytes(0, 3) + Bytes<uint64_t>(9) + SensorBytes(0, 7) +
         Bytes<uint64_t>(4) + SensorBytes(1, 9) + Bytes<uint64_t>(50) + Bytes<uint32_t>(7) +
         Bytes<uint32_t>(1) + PoseBytes(4, 5, 6) + Bytes<uint32_t>(1) + SensorBytes(0, 3) +
         Bytes<uint64_t>(5);
}

void ExpectRigs(const std::vector<Rig>& rigs) {
  ASSERT_EQ(rigs.size(), 2u);
  ASSERT_EQ(rigs[0].sensors.size(), 3u);
  EXPECT_EQ(rigs[0].NumCameras(), 2);
  EXPECT_TRUE(rigs[0].sensors[0].has_pose);
  EXPECT_EQ(rigs[0].sensors[0].sensor_from_rig.translation, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(rigs[0].sensors[1].sensor, (SensorId{0, 7}));
  EXPECT_EQ(rigs[0].sensors[1].sensor_from_rig.translation, Eigen::Vector3d(0.5, 0, 0));
  EXPECT_EQ(rigs[0].sensors[2].sensor, (SensorId{1, 9}));
  EXPECT_FALSE(rigs[1].sensors[1].has_pose);
}

void ExpectFrames(const std::vector<Frame>& frames) {
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].id, 6u);
  EXPECT_EQ(frames[0].rig_id, 1u);
  EXPECT_EQ(frames[0].rig_from_world.translation, Eigen::Vector3d(1, 2, 3));
  ASSERT_EQ(frames[0].data.size(), 3u);
  EXPECT_EQ(frames[0].data[1].id, 4u);
  EXPECT_EQ(frames[0].data[2].sensor.type, 1);
  ASSERT_EQ(frames[1].data.size(), 1u);
  EXPECT_EQ(frames[1].data[0].id, 5u);
}

std::vector<Rig> TextRigs() {
  std::istringstream in(kRigsText);
  return ReadRigsText(in, "rigs.txt");
}

std::vector<Frame> TextFrames() {
  std::istringstream in(kFramesText);
  return ReadFramesText(in, "frames.txt");
}

SparseModel ModelWithRigs() {
  SparseModel model = MakeModel();
  model.rigs = TextRigs();
  model.frames = TextFrames();
  return model;
}

TEST(Rig, TextIsRead) {
  ExpectRigs(TextRigs());
  ExpectFrames(TextFrames());
}

TEST(Rig, BinaryIsRead) {
  std::istringstream rigs(RigsBinary()), frames(FramesBinary());
  ExpectRigs(ReadRigsBinary(rigs, "rigs.bin"));
  ExpectFrames(ReadFramesBinary(frames, "frames.bin"));
}

TEST(Rig, WhatIsReadIsWrittenAgain) {
  const SparseModel model = ModelWithRigs();
  std::ostringstream rigs, frames;
  WriteRigsBinary(model, rigs);
  WriteFramesBinary(model, frames);
  EXPECT_EQ(rigs.str(), RigsBinary());
  EXPECT_EQ(frames.str(), FramesBinary());
  std::stringstream rigs_text, frames_text;
  WriteRigsText(model, rigs_text);
  WriteFramesText(model, frames_text);
  ExpectRigs(ReadRigsText(rigs_text, "rigs.txt"));
  ExpectFrames(ReadFramesText(frames_text, "frames.txt"));
}

TEST(Rig, EveryTruncationOfBinaryIsNoticed) {
  const std::string rigs = RigsBinary();
  for (size_t size = 0; size < rigs.size(); ++size) {
    std::istringstream in(rigs.substr(0, size));
    EXPECT_THROW(ReadRigsBinary(in, "rigs.bin"), IoError) << size;
  }
  const std::string frames = FramesBinary();
  for (size_t size = 0; size < frames.size(); ++size) {
    std::istringstream in(frames.substr(0, size));
    EXPECT_THROW(ReadFramesBinary(in, "frames.bin"), IoError) << size;
  }
}

TEST(Rig, ComposedPoseWinsWithOneWarning) {
  SparseModel model = ModelWithRigs();
  ApplyRigs(&model);
  EXPECT_EQ(model.images[0].cam_from_world.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(model.images[1].cam_from_world.translation, Eigen::Vector3d(1.5, 2, 3));
  EXPECT_EQ(model.images[2].cam_from_world.translation, Eigen::Vector3d(4, 5, 6));
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("3 image poses differ")));
  // Now they agree.
  model.warnings.clear();
  ApplyRigs(&model);
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(Rig, RotatedRigsCompose) {
  const double half = std::sqrt(0.5);
  SparseModel model = MakeModel();
  // A quarter turn about z, then a shift.
  model.rigs = {{1, {{{kCameraSensor, 3}, true, {{half, 0, 0, half}, {10, 0, 0}}}}}};
  Frame frame;
  frame.rig_id = 1;
  frame.rig_from_world.translation = {1, 0, 0};
  frame.data = {{{kCameraSensor, 3}, 9}};
  model.frames = {frame};
  ApplyRigs(&model);
  const Eigen::Vector3d origin_in_cam = model.images[0].cam_from_world * Eigen::Vector3d::Zero();
  EXPECT_LT((origin_in_cam - Eigen::Vector3d(10, 1, 0)).norm(), 1e-14);
}

TEST(Rig, PoseIsKeptWhereRigsDoNotTell) {
  const SparseModel before = MakeModel();
  SparseModel model = ModelWithRigs();
  model.rigs[0].sensors[1].has_pose = false;  // image 4
  model.frames[1].rig_id = 99;                // image 5
  model.frames[0].data.push_back({{kCameraSensor, 3}, 9});
  ApplyRigs(&model);
  for (const int i : {1, 2}) {
    EXPECT_EQ(model.images[i].cam_from_world.translation,
              before.images[i].cam_from_world.translation);
  }
  EXPECT_THAT(model.warnings,
              ElementsAre(HasSubstr("1 image poses"), HasSubstr("2 images have no pose by rigs"),
                          HasSubstr("1 images are in two frames")));
}

TEST(Rig, IsAppliedWhenAModelIsRead) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  dir.WriteFile("rigs.bin", RigsBinary());
  SparseModel model = ReadColmapModel(dir.path());
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("frames.bin is missing")));
  EXPECT_EQ(model.images[0].cam_from_world.translation.x(), 0.9);
  EXPECT_THAT(model.rigs, IsEmpty());
  dir.WriteFile("frames.bin", FramesBinary());
  model = ReadColmapModel(dir.path());
  EXPECT_EQ(model.images[0].cam_from_world.translation.x(), 1);
  ExpectRigs(model.rigs);
  ExpectFrames(model.frames);
}

TEST(Rig, IsWrittenWithTheModelAndGoesWithIt) {
  SparseModel model = ModelWithRigs();
  ApplyRigs(&model);
  const TempDir dir;
  for (const auto write : {WriteModelBinary, WriteModelText}) {
    write(model, dir.path());
    const SparseModel read = ReadColmapModel(dir.path());
    ExpectRigs(read.rigs);
    ExpectFrames(read.frames);
    EXPECT_THAT(read.warnings, IsEmpty());
    // Those of another model would replace its poses.
    write(MakeModel(), dir.path());
    EXPECT_THAT(ReadColmapModel(dir.path()).rigs, IsEmpty());
    EXPECT_THAT(ReadColmapModel(dir.path()).warnings, IsEmpty());
    std::filesystem::remove(dir / "cameras.bin");
  }
}

TEST(Rig, OfAnEarlierModelIsRemovedBeforeAnythingIsWritten) {
  const TempDir dir;
  dir.WriteFile("frames.txt", kFramesText);
  dir.WriteFile("cameras.txt/in the way", "");
  EXPECT_THROW(WriteModelText(MakeModel(), dir.path()), IoError);
  EXPECT_FALSE(std::filesystem::exists(dir / "frames.txt"));
}

TEST(Rig, OfAnEarlierModelThatStaysIsAnError) {
  const TempDir dir;
  dir.WriteFile("rigs.txt/in the way", "");
  EXPECT_THAT(ErrorText<IoError>([&] { WriteModelText(MakeModel(), dir.path()); }),
              HasSubstr("rigs.txt: cannot be removed: "));
  EXPECT_FALSE(std::filesystem::exists(dir / "images.txt"));
}

TEST(Rig, OfSingleCamerasIsNone) {
  const TempDir dir;
  WriteModelText(MakeModel(), dir.path());
  dir.WriteFile("rigs.txt", "1 1 CAMERA 3\n2 1 CAMERA 7\n");
  dir.WriteFile("frames.txt", "1 1 1 0 0 0 1 2 3 1 CAMERA 3 9\n");
  const SparseModel model = ReadColmapModel(dir.path());
  EXPECT_EQ(model.images[0].cam_from_world.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(model.rigs[0].NumCameras(), 1);
}

// Three frames of a rig of two cameras, and one of the second camera alone.
SparseModel ModelOfRig() {
  SparseModel model;
  const SensorId left = {kCameraSensor, 1}, right = {kCameraSensor, 2};
  model.cameras = {MakeCamera(CameraModelId::kPinhole, 1), MakeCamera(CameraModelId::kPinhole, 2)};
  Rigid3d right_from_left;
  right_from_left.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  right_from_left.translation = {-1, 0.125, 0.25};
  model.rigs = {{1, {{left, true, {}}, {right, true, right_from_left}}}};
  for (uint32_t f = 0; f < 4; ++f) {
    Frame frame;
    frame.id = f;
    frame.rig_id = 1;
    frame.rig_from_world.rotation =
        Eigen::AngleAxisd(0.75 * f, Eigen::Vector3d(1, 2, 3).normalized());
    frame.rig_from_world.translation = {0.5 * f, 1, 5};
    for (const uint32_t camera : {1u, 2u}) {
      if (f == 3 && camera == 1) continue;
      ModelImage image;
      image.id = 10 * f + camera;
      image.camera_id = camera;
      image.name = std::to_string(image.id);
      model.images.push_back(image);
      frame.data.push_back({{kCameraSensor, camera}, image.id});
    }
    model.frames.push_back(frame);
  }
  ApplyRigs(&model);
  model.warnings.clear();
  return model;
}

double LargestDifference(const SparseModel& a, const SparseModel& b) {
  double largest = 0;
  for (size_t i = 0; i < a.images.size(); ++i) {
    const Rigid3d& x = a.images[i].cam_from_world;
    const Rigid3d& y = b.images[i].cam_from_world;
    largest = std::max(
        {largest, x.rotation.angularDistance(y.rotation), (x.translation - y.translation).norm()});
  }
  return largest;
}

std::set<size_t> AllImages(const SparseModel& model) {
  std::set<size_t> images;
  for (size_t i = 0; i < model.images.size(); ++i) images.insert(i);
  return images;
}

TEST(RigFit, FramesAndSensorsFollowPosesOfARigidRig) {
  SparseModel moved = ModelOfRig();
  // Another rig, in other places.
  moved.rigs[0].sensors[1].sensor_from_rig.translation.x() += 0.1;
  moved.rigs[0].sensors[1].sensor_from_rig.rotation =
      Eigen::AngleAxisd(0.45, Eigen::Vector3d(0.1, 1, 0).normalized());
  for (Frame& frame : moved.frames) frame.rig_from_world.translation.z() += 0.2;
  ApplyRigs(&moved);
  SparseModel model = ModelOfRig();
  for (size_t i = 0; i < model.images.size(); ++i) {
    model.images[i].cam_from_world = moved.images[i].cam_from_world;
  }
  FitRigs(AllImages(model), &model);
  EXPECT_LT(LargestDifference(model, moved), 1e-9);
  EXPECT_LT((model.rigs[0].sensors[1].sensor_from_rig.translation -
             moved.rigs[0].sensors[1].sensor_from_rig.translation)
                .norm(),
            1e-9);
  EXPECT_TRUE(model.rigs[0].sensors[0].sensor_from_rig.translation.isZero());
  // Poses of images are those that a reader composes.
  ApplyRigs(&model);
  EXPECT_THAT(model.warnings, IsEmpty());
}

// Each image is moved and turned in another way.
SparseModel ModelOfBentRig() {
  SparseModel model = ModelOfRig();
  for (size_t i = 0; i < model.images.size(); ++i) {
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(0.01 * std::sin(5.0 * i),
                                      Eigen::Vector3d(std::cos(i), std::sin(i), 0.5).normalized());
    turn.translation = 0.01 * Eigen::Vector3d(std::sin(i), std::cos(3.0 * i), 0);
    model.images[i].cam_from_world = turn * model.images[i].cam_from_world;
  }
  return model;
}

TEST(RigFit, OfPosesThatNoRigHasIsNear) {
  const SparseModel given = ModelOfBentRig();
  SparseModel model = given;
  FitRigs(AllImages(model), &model);
  EXPECT_GT(LargestDifference(model, given), 1e-4);
  EXPECT_LT(LargestDifference(model, given), 0.06);
  // The last frame has one image, which nothing contradicts.
  EXPECT_LT((model.images.back().cam_from_world.translation -
             given.images.back().cam_from_world.translation)
                .norm(),
            1e-9);
  // Nothing is left to improve.
  SparseModel again = model;
  FitRigs(AllImages(again), &again);
  EXPECT_LT(LargestDifference(again, model), 1e-9);
}

// A ring of sensors; every frame is of two neighbors, each pair in turn, some frames more than
// once.
SparseModel ModelOfSensorsInTurns(uint32_t num_sensors) {
  SparseModel model;
  Rig rig;
  rig.id = 1;
  for (uint32_t s = 0; s < num_sensors; ++s) {
    model.cameras.push_back(MakeCamera(CameraModelId::kPinhole, s + 1));
    RigSensor sensor{{kCameraSensor, s + 1}, true, {}};
    const double angle = 2 * M_PI * s / num_sensors;
    if (s > 0) {
      sensor.sensor_from_rig = {
          Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.1, 1, 0).normalized())),
          {std::sin(angle), 0.01 * s, std::cos(angle)}};
    }
    rig.sensors.push_back(sensor);
  }
  model.rigs = {rig};
  for (uint32_t f = 0; f + 1 < 2 * num_sensors; ++f) {
    const Eigen::Vector3d axis = Eigen::Vector3d(std::sin(f), 2, std::cos(f)).normalized();
    Frame frame{f, 1, {Eigen::Quaterniond(Eigen::AngleAxisd(0.2 * f, axis)), {0.5 * f, 1, 5}}, {}};
    for (uint32_t k = 0; k < 2; ++k) {
      ModelImage image;
      image.id = 2 * f + k;
      image.camera_id = (f + k) % num_sensors + 1;
      image.name = std::to_string(image.id);
      frame.data.push_back({{kCameraSensor, image.camera_id}, image.id});
      model.images.push_back(image);
    }
    model.frames.push_back(frame);
  }
  ApplyRigs(&model);
  model.warnings.clear();
  return model;
}

// The same images, with sensors and frames somewhere else.
SparseModel WithOtherRig(SparseModel model) {
  for (size_t s = 1; s < model.rigs[0].sensors.size(); ++s) {
    const Rigid3d by = {Eigen::Quaterniond(Eigen::AngleAxisd(
                            0.1 * std::sin(s), Eigen::Vector3d(1, std::cos(s), 0).normalized())),
                        {0.1 * std::sin(3.0 * s), 0.05, 0}};
    Rigid3d& pose = model.rigs[0].sensors[s].sensor_from_rig;
    pose = by * pose;
  }
  for (Frame& frame : model.frames) frame.rig_from_world.translation.x() += 0.2;
  return model;
}

TEST(RigFit, OfSensorsThatFireInTurnsIsExact) {
  for (const uint32_t num_sensors : {5, 17, 33, 120}) {
    const SparseModel given = ModelOfSensorsInTurns(num_sensors);
    SparseModel model = WithOtherRig(given);
    FitRigs(AllImages(model), &model);
    EXPECT_LT(LargestDifference(model, given), 1e-9) << num_sensors;
  }
}

// Then only the positions of frames and sensors relative to each other are determined, not which of
// the two moved.
TEST(RigFit, NeedsNoImageOfTheReference) {
  const SparseModel given = ModelOfSensorsInTurns(7);
  SparseModel model = WithOtherRig(given);
  std::set<size_t> images;
  for (size_t i = 0; i < model.images.size(); ++i) {
    if (model.images[i].camera_id != 1) images.insert(i);
  }
  FitRigs(images, &model);
  for (const size_t i : images) {
    EXPECT_LT(
        (model.images[i].cam_from_world.translation - given.images[i].cam_from_world.translation)
            .norm(),
        1e-9);
  }
  for (const RigSensor& sensor : model.rigs[0].sensors) {
    EXPECT_LT(sensor.sensor_from_rig.translation.norm(), 2);
  }
}

TEST(Rig, ImagesOfSharedRigsAreThoseThatDependOnEachOther) {
  SparseModel model = ModelOfRig();
  EXPECT_EQ(ImagesOfSharedRigs(AllImages(model), model), AllImages(model));
  EXPECT_THAT(ImagesOfSharedRigs({0, 3}, model), ElementsAre(0, 3));
  EXPECT_THAT(ImagesOfSharedRigs({0, 2, 4}, model), IsEmpty()) << "of one camera";
  model.frames[1].data.clear();  // images 2 and 3 are in no frame
  EXPECT_THAT(ImagesOfSharedRigs({0, 1, 2, 3}, model), ElementsAre(0, 1));
}

TEST(RigFit, DoesNotDependOnWhereTheOriginIs) {
  SparseModel near = ModelOfBentRig();
  SparseModel far = near;
  const Eigen::Vector3d shift(5e5, 4e6, 100);
  const auto move = [](const Eigen::Vector3d& by, SparseModel* model) {
    MoveModel(by, model);
    for (Frame& frame : model->frames) frame.rig_from_world = Moved(frame.rig_from_world, by);
  };
  move(shift, &far);
  FitRigs(AllImages(near), &near);
  FitRigs(AllImages(far), &far);
  EXPECT_LT((near.rigs[0].sensors[1].sensor_from_rig.translation -
             far.rigs[0].sensors[1].sensor_from_rig.translation)
                .norm(),
            1e-7);
  move(-shift, &far);
  EXPECT_LT(LargestDifference(near, far), 1e-7);
}

TEST(RigFit, ImagesThatWereNotRefinedFollowTheOthers) {
  const SparseModel given = ModelOfRig();
  SparseModel model = given;
  // Frame 0 was refined, and of frame 1 the left image; frames 2 and 3 were not.
  const Rigid3d change = {Eigen::Quaterniond::Identity(), {0.25, 0.5, -0.125}};
  for (const size_t i : {0, 1, 2}) {
    model.images[i].cam_from_world = change * given.images[i].cam_from_world;
  }
  model.images[1].cam_from_world = change * model.images[1].cam_from_world;
  const SparseModel refined = model;
  FitRigs({0, 1, 2}, &model);
  const auto distance = [](const Rigid3d& a, const Rigid3d& b) {
    return (a * Inverse(b)).translation.norm();
  };
  for (const size_t i : {0, 1, 2}) {
    EXPECT_LT(distance(model.images[i].cam_from_world, refined.images[i].cam_from_world), 1e-9);
  }
  for (const size_t f : {2, 3}) {
    EXPECT_EQ(model.frames[f].rig_from_world.translation,
              given.frames[f].rig_from_world.translation);
  }
  EXPECT_EQ(model.images[4].cam_from_world.translation, given.images[4].cam_from_world.translation);
  for (const size_t i : {3, 5, 6}) {  // of the right camera
    EXPECT_GT(distance(model.images[i].cam_from_world, given.images[i].cam_from_world), 0.1);
  }
  ApplyRigs(&model);
  EXPECT_THAT(model.warnings, IsEmpty());
}

}  // namespace
}  // namespace limn::colmap_ext
