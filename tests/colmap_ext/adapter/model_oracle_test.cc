// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's library as an oracle for models: it reads what we write, and the reverse.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "colmap_ext/adapter/colmap_versions.h"
#include "colmap_ext/adapter/reconstruction_model.h"
#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

SparseModel SortedById(SparseModel model) {
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(model.cameras.begin(), model.cameras.end(), by_id);
  std::sort(model.images.begin(), model.images.end(), by_id);
  std::sort(model.points.begin(), model.points.end(), by_id);
  return model;
}

// ExpectSameModel, and rotations to the last bit.
void ExpectSameBits(const SparseModel& actual, const SparseModel& expected) {
  ExpectSameModel(actual, expected);
  ASSERT_EQ(actual.images.size(), expected.images.size());
  for (size_t i = 0; i < actual.images.size(); ++i) {
    EXPECT_EQ(actual.images[i].cam_from_world.rotation.coeffs(),
              expected.images[i].cam_from_world.rotation.coeffs());
  }
  EXPECT_EQ(actual.warnings, expected.warnings);
  // From 3.12 on COLMAP makes a rig of every camera where the files have none.
  if (expected.rigs.empty()) {
    for (const Rig& rig : actual.rigs) EXPECT_EQ(rig.sensors.size(), 1u);
  } else {
    EXPECT_EQ(actual.rigs.size(), expected.rigs.size());
    EXPECT_EQ(actual.frames.size(), expected.frames.size());
  }
}

SparseModel ReadByColmap(const fs::path& folder) {
  colmap::Reconstruction reconstruction;
  reconstruction.Read(folder.string());
  return ToSparseModel(reconstruction);
}

// Every camera model that 3.8 has, images without a common order, random numbers. Names without
// spaces, which COLMAP's text cannot hold.
SparseModel RandomModel() {
  std::mt19937 random(7);
  testing::NormalDistribution<double> number;
  SparseModel model;
  for (int id = 0; id <= 10; ++id) {
    model.cameras.push_back(MakeCamera(static_cast<CameraModelId>(id), 100 - id));
  }
  for (uint32_t id : {5, 3, 900, 17, 4, 8, 1000000, 12}) {
    ModelImage image;
    image.id = id;
    image.camera_id = model.cameras[id % 11].id;
    image.name = "sub/" + std::to_string(1000 - id % 1000) + ".jpg";
    image.cam_from_world.rotation =
        Eigen::Quaterniond(number(random), number(random), number(random), number(random))
            .normalized();
    image.cam_from_world.translation = {number(random), number(random), number(random)};
    for (int i = 0; i < 20; ++i) {
      image.observations.push_back(
          {{400 + 100 * number(random), 300 + 80 * number(random)}, kNoPoint3D});
    }
    model.images.push_back(image);
  }
  for (uint32_t p = 0; p < 15; ++p) {
    ModelPoint point;
    point.id = 1000 - 7 * p;
    point.position = {number(random), number(random), number(random)};
    point.color = {static_cast<uint8_t>(p), 255, 7};
    point.error = std::abs(number(random));
    for (ModelImage& image : model.images) {
      if ((p + image.id) % 3 == 0) continue;
      image.observations[p].point3D_id = point.id;
      point.track.push_back({image.id, p});
    }
    model.points.push_back(point);
  }
  return model;
}

TEST(ColmapLibraryModels, OurFilesAreReadTheSame) {
  const TempDir dir;
  WriteModelBinary(RandomModel(), dir.path());
  const SparseModel ours = SortedById(ReadColmapModel(dir.path()));
  EXPECT_EQ(ours.images.size(), 8u);
  ExpectSameBits(ReadByColmap(dir.path()), ours);
  const TempDir text;
  WriteModelText(RandomModel(), text.path());
  ExpectSameBits(ReadByColmap(text.path()), SortedById(ReadColmapModel(text.path())));
}

TEST(ColmapLibraryModels, NamesWithSpacesInBinaryFiles) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  ExpectSameBits(ReadByColmap(dir.path()), SortedById(ReadColmapModel(dir.path())));
}

TEST(ColmapLibraryModels, ColmapsFilesAreReadTheSame) {
  for (const fs::path& given : {fs::path(LIMN_SAMPLE_DIR "/day/sparse"), fs::path()}) {
    const TempDir from;
    if (given.empty()) WriteModelBinary(RandomModel(), from.path());
    const fs::path folder = given.empty() ? from.path() : given;
    colmap::Reconstruction reconstruction;
    reconstruction.Read(folder.string());
    ExpectSameBits(ToSparseModel(reconstruction), SortedById(ReadColmapModel(folder)));
    const TempDir binary, text;
    reconstruction.WriteBinary(binary.path().string());
    ExpectSameBits(ReadByColmap(binary.path()), SortedById(ReadColmapModel(binary.path())));
    reconstruction.WriteText(text.path().string());
    ExpectSameBits(ReadByColmap(text.path()), SortedById(ReadColmapModel(text.path())));
    ExpectSameModel(SortedById(ReadColmapModel(text.path())), ToSparseModel(reconstruction));
  }
}

template <typename Reconstruction>
constexpr bool HasRigs() {
  return requires(Reconstruction reconstruction) { reconstruction.Rigs(); };
}

// Two cameras on a rig; the poses of the images are others.
SparseModel ModelWithRig() {
  SparseModel model = RandomModel();
  model.images.resize(2);
  model.points.clear();
  for (ModelImage& image : model.images) image.observations.clear();
  std::sort(model.images.begin(), model.images.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto camera_of = [&](int i) { return SensorId{kCameraSensor, model.images[i].camera_id}; };
  const Rigid3d right = {Eigen::Quaterniond(1, 0.1, -0.2, 0.05).normalized(), {-0.3, 0.01, 0.02}};
  model.rigs = {{7, {{camera_of(0), true, {}}, {camera_of(1), true, right}}}};
  const Rigid3d pose = {Eigen::Quaterniond(0.5, 0.3, 0.7, 0.1).normalized(), {1, 2, 3}};
  model.frames = {{8, 7, pose, {}}};
  for (int i = 0; i < 2; ++i) model.frames[0].data.push_back({camera_of(i), model.images[i].id});
  return model;
}

TEST(ColmapLibraryModels, RigsGiveTheSamePoses) {
  if (!HasRigs<colmap::Reconstruction>()) GTEST_SKIP() << "this version of COLMAP has no rigs";
  const TempDir dir;
  WriteModelBinary(ModelWithRig(), dir.path());
  SparseModel ours = SortedById(ReadColmapModel(dir.path()));
  ASSERT_EQ(ours.rigs.size(), 1u);
  ASSERT_EQ(ours.warnings.size(), 1u) << "the images file has other poses";
  ours.warnings.clear();
  const SparseModel theirs = ReadByColmap(dir.path());
  ExpectSameBits(theirs, ours);
  EXPECT_EQ(theirs.frames[0].rig_from_world.rotation.coeffs(),
            ours.frames[0].rig_from_world.rotation.coeffs());
}

// From 3.12 on an image is in a frame, which has the pose.
template <typename Reconstruction, typename Image>
void AddWithoutPose(const Image& image, Reconstruction* reconstruction) {
  if constexpr (requires { reconstruction->AddImageWithTrivialFrame(image); }) {
    reconstruction->AddImageWithTrivialFrame(image);
  } else {
    reconstruction->AddImage(image);
  }
}

TEST(ColmapLibraryModels, UnregisteredImagesAreLeftOut) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  colmap::Reconstruction reconstruction;
  reconstruction.Read(dir.path().string());
  colmap::Image image;
  image.SetImageId(77);
  image.SetName("not registered.png");
  image.SetCameraId(3);
  AddWithoutPose(image, &reconstruction);
  EXPECT_EQ(ToSparseModel(reconstruction).images.size(), 3u);
}

TEST(ColmapLibraryModels, WhatIsNoModelIsRefused) {
  const TempDir dir;
  SparseModel bad = MakeModel();
  bad.cameras[0].params[0] = -1;
  WriteModelBinary(bad, dir.path());
  colmap::Reconstruction reconstruction;
  reconstruction.Read(dir.path().string());
  EXPECT_EQ(ErrorText<IoError>([&] { ToSparseModel(reconstruction); }),
            "reconstruction: id 7: camera 7: the focal length is not positive");
}

// As AddCurvePoints leaves it: observations and points at the ends.
TEST(ColmapLibraryModels, PointsAreAppendedWithTheirTracks) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  colmap::Reconstruction reconstruction;
  reconstruction.Read(dir.path().string());
  SparseModel model = ToSparseModel(reconstruction);
  const size_t num_before = model.points.size();
  ModelPoint point = {1001, {1, 2, 3}, {4, 5, 6}, 0, {}};
  for (ModelImage& image : model.images) {
    point.track.push_back({image.id, static_cast<uint32_t>(image.observations.size())});
    image.observations.push_back({{12.5, image.id + 0.25}, point.id});
  }
  model.points.push_back(point);
  AppendPoints(model, num_before, &reconstruction);
  ExpectSameModel(ToSparseModel(reconstruction), model);
  for (const ModelImage& image : model.images) {
    EXPECT_EQ(reconstruction.Image(image.id).NumPoints3D(),
              std::count_if(image.observations.begin(), image.observations.end(),
                            [](const Observation& o) { return o.point3D_id != kNoPoint3D; }));
  }
  const TempDir written;
  reconstruction.WriteBinary(written.path().string());
  ExpectSameModel(SortedById(ReadColmapModel(written.path())), model);
}

}  // namespace
}  // namespace limn::colmap_ext
