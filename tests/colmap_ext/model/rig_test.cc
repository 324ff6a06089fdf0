#include "colmap_ext/model/rig.h"

#include <cmath>
#include <cstring>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
  ASSERT_EQ(rigs[0].cameras.size(), 2u);
  EXPECT_TRUE(rigs[0].cameras.at(3).has_pose);
  EXPECT_EQ(rigs[0].cameras.at(3).cam_from_rig.translation, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(rigs[0].cameras.at(7).cam_from_rig.translation, Eigen::Vector3d(0.5, 0, 0));
  EXPECT_FALSE(rigs[1].cameras.at(21).has_pose);
}

void ExpectFrames(const std::vector<Frame>& frames) {
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].id, 6u);
  EXPECT_EQ(frames[0].rig_id, 1u);
  EXPECT_EQ(frames[0].rig_from_world.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(frames[0].image_ids, ElementsAre(9u, 4u));
  EXPECT_THAT(frames[1].image_ids, ElementsAre(5u));
}

std::vector<Rig> TextRigs() {
  std::istringstream in(kRigsText);
  return ReadRigsText(in, "rigs.txt");
}

std::vector<Frame> TextFrames() {
  std::istringstream in(kFramesText);
  return ReadFramesText(in, "frames.txt");
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
  SparseModel model = MakeModel();
  ApplyRigs(TextRigs(), TextFrames(), &model);
  EXPECT_EQ(model.images[0].cam_from_world.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(model.images[1].cam_from_world.translation, Eigen::Vector3d(1.5, 2, 3));
  EXPECT_EQ(model.images[2].cam_from_world.translation, Eigen::Vector3d(4, 5, 6));
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("3 image poses differ")));
  // Now they agree.
  model.warnings.clear();
  ApplyRigs(TextRigs(), TextFrames(), &model);
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(Rig, RotatedRigsCompose) {
  const double half = std::sqrt(0.5);
  Rig rig;
  rig.id = 1;
  // A quarter turn about z, then a shift.
  rig.cameras[3] = {true, {{half, 0, 0, half}, {10, 0, 0}}};
  Frame frame;
  frame.rig_id = 1;
  frame.rig_from_world.translation = {1, 0, 0};
  frame.image_ids = {9};
  SparseModel model = MakeModel();
  ApplyRigs({rig}, {frame}, &model);
  const Eigen::Vector3d origin_in_cam = model.images[0].cam_from_world * Eigen::Vector3d::Zero();
  EXPECT_LT((origin_in_cam - Eigen::Vector3d(10, 1, 0)).norm(), 1e-14);
}

TEST(Rig, PoseIsKeptWhereRigsDoNotTell) {
  const SparseModel before = MakeModel();
  std::vector<Rig> rigs = TextRigs();
  rigs[0].cameras.at(7).has_pose = false;  // image 4
  std::vector<Frame> frames = TextFrames();
  frames[1].rig_id = 99;  // image 5
  frames[0].image_ids.push_back(9);
  SparseModel model = before;
  ApplyRigs(rigs, frames, &model);
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
  EXPECT_FALSE(model.has_rigs);
  dir.WriteFile("frames.bin", FramesBinary());
  model = ReadColmapModel(dir.path());
  EXPECT_EQ(model.images[0].cam_from_world.translation.x(), 1);
  EXPECT_TRUE(model.has_rigs);
}

TEST(Rig, OfSingleCamerasIsNone) {
  const TempDir dir;
  WriteModelText(MakeModel(), dir.path());
  dir.WriteFile("rigs.txt", "1 1 CAMERA 3\n2 1 CAMERA 7\n");
  dir.WriteFile("frames.txt", "1 1 1 0 0 0 1 2 3 1 CAMERA 3 9\n");
  const SparseModel model = ReadColmapModel(dir.path());
  EXPECT_EQ(model.images[0].cam_from_world.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(model.has_rigs);
}

}  // namespace
}  // namespace limn::colmap_ext
