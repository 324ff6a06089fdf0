// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_files.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Files {
  std::string cameras;
  std::string images;
  std::string points;
};

Files Write(const SparseModel& model) {
  std::ostringstream cameras, images, points;
  WriteCamerasBinary(model, cameras);
  WriteImagesBinary(model, images);
  WritePointsBinary(model, points);
  return {cameras.str(), images.str(), points.str()};
}

SparseModel ReadBinary(const Files& files) {
  ModelBuilder builder;
  std::istringstream cameras(files.cameras), images(files.images), points(files.points);
  ReadCamerasBinary(cameras, "cameras.bin", &builder);
  ReadImagesBinary(images, "images.bin", &builder);
  ReadPointsBinary(points, "points3D.bin", &builder);
  return builder.Finish();
}

std::string ErrorOfBinary(const Files& files) {
  return ErrorText<IoError>([&] { ReadBinary(files); });
}

std::string ErrorOfBinary(const SparseModel& model) { return ErrorOfBinary(Write(model)); }

template <typename T>
void Overwrite(std::string* bytes, size_t offset, T value) {
  std::memcpy(bytes->data() + offset, &value, sizeof(T));
}

// Offsets in images.bin of the first record.
constexpr size_t kQuaternion = 8 + 4;
constexpr size_t kTranslation = kQuaternion + 32;

TEST(BinaryModel, RoundTrips) {
  const SparseModel model = MakeModel();
  const SparseModel back = ReadBinary(Write(model));
  ExpectSameModel(back, model);
  EXPECT_THAT(back.warnings, IsEmpty());
}

TEST(BinaryModel, RoundTripsEveryCameraModel) {
  SparseModel model;
  for (int id = 0; id < 17; ++id) {
    model.cameras.push_back(MakeCamera(static_cast<CameraModelId>(id), 100 - id));
  }
  ExpectSameModel(ReadBinary(Write(model)), model);
}

TEST(BinaryModel, EveryTruncationIsNoticed) {
  const Files files = Write(MakeModel());
  for (std::string Files::*member : {&Files::cameras, &Files::images, &Files::points}) {
    for (size_t size = 0; size < (files.*member).size(); ++size) {
      Files cut = files;
      (cut.*member).resize(size);
      EXPECT_THAT(ErrorOfBinary(cut), AllOf(HasSubstr(".bin: byte "), HasSubstr("truncated")))
          << size;
    }
  }
}

TEST(BinaryModel, TrailingBytesAreNoticed) {
  const Files files = Write(MakeModel());
  for (std::string Files::*member : {&Files::cameras, &Files::images, &Files::points}) {
    Files longer = files;
    (longer.*member) += "x";
    EXPECT_THAT(ErrorOfBinary(longer), HasSubstr("1 bytes after the last record"));
  }
}

TEST(BinaryModel, HugeCountsAreRefusedBeforeMemoryIsTaken) {
  const Files files = Write(MakeModel());
  for (std::string Files::*member : {&Files::cameras, &Files::images, &Files::points}) {
    Files huge = files;
    Overwrite<uint64_t>(&(huge.*member), 0, 0x7FFFFFFFFFFFFFFF);
    EXPECT_THAT(ErrorOfBinary(huge), HasSubstr("byte 0: number of"));
  }
}

TEST(BinaryModel, TextInPlaceOfBinaryIsCalledThat) {
  Files files = Write(MakeModel());
  files.cameras = "version https://git-lfs.github.com/spec/v1\n";
  EXPECT_THAT(ErrorOfBinary(files),
              HasSubstr("cameras.bin: byte 0: text, not a binary COLMAP file"));
}

TEST(BinaryModel, UnknownCameraModelIsNamed) {
  Files files = Write(MakeModel());
  Overwrite<int32_t>(&files.cameras, 8 + 4, 99);
  EXPECT_THAT(ErrorOfBinary(files),
              AllOf(HasSubstr("cameras.bin: byte 8: camera 7"),
                    HasSubstr("unknown camera model id 99"), HasSubstr("PINHOLE")));
}

TEST(BinaryModel, EquirectangularImagesAreTwiceAsWideAsHigh) {
  SparseModel model = MakeModel();
  model.cameras[0] = {7, CameraModelId::kEquirectangular, 800, 400, {800, 400}};
  EXPECT_EQ(ErrorOfBinary(model), "");
  model.cameras[0] = {7, CameraModelId::kEquirectangular, 800, 600, {800, 600}};
  EXPECT_THAT(ErrorOfBinary(model),
              HasSubstr("camera 7: an EQUIRECTANGULAR image of 800 x 600 pixels is "
                        "not twice as wide as high"));
  model.cameras[0] = {7, CameraModelId::kEquirectangular, 800, 400, {400, 200}};
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("must be its width and height"));
}

TEST(BinaryModel, SenselessCamerasAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double focal : {0.0, -500.0, std::nan(""), infinity}) {
    SparseModel model = MakeModel();
    model.cameras[1].params[1] = focal;
    EXPECT_THAT(ErrorOfBinary(model), HasSubstr("camera 3: ")) << focal;
  }
  for (const double focal : {1e-300, 0.5, 1e9}) {
    SparseModel model = MakeModel();
    model.cameras[1].params[1] = focal;
    EXPECT_THAT(ErrorOfBinary(model), HasSubstr("px makes no sense for images of 800 x 600"))
        << focal;
  }
  for (const uint64_t width : {uint64_t{0}, uint64_t{1000001}}) {
    SparseModel model = MakeModel();
    model.cameras[1].width = width;
    EXPECT_THAT(ErrorOfBinary(model), HasSubstr("makes no sense")) << width;
  }
  SparseModel model = MakeModel();
  model.cameras[1].id = 7;
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("camera 7 is defined twice"));
}

TEST(BinaryModel, PrincipalPointOutsideTheImageIsAWarning) {
  SparseModel model = MakeModel();
  model.cameras[0].params[2] = -1;
  EXPECT_THAT(ReadBinary(Write(model)).warnings,
              ::testing::ElementsAre(HasSubstr("1 cameras have their principal point outside")));
}

TEST(BinaryModel, PosesThatAreNoPosesAreRefused) {
  const Files good = Write(MakeModel());
  Files files = good;
  for (int i = 0; i < 4; ++i) Overwrite(&files.images, kQuaternion + 8 * i, 0.0);
  EXPECT_THAT(ErrorOfBinary(files),
              HasSubstr("images.bin: byte 8: image 9 (c.png): the rotation is a zero quaternion"));
  files = good;
  Overwrite(&files.images, kQuaternion, std::nan(""));
  EXPECT_THAT(ErrorOfBinary(files), HasSubstr("the pose is not finite"));
  files = good;
  Overwrite(&files.images, kTranslation, -std::numeric_limits<double>::infinity());
  EXPECT_THAT(ErrorOfBinary(files), HasSubstr("the pose is not finite"));
}

TEST(BinaryModel, RotationsAreNormalized) {
  SparseModel model = MakeModel();
  const Eigen::Quaterniond unit = model.images[0].cam_from_world.rotation;
  model.images[0].cam_from_world.rotation.coeffs() *= 3;
  const SparseModel back = ReadBinary(Write(model));
  EXPECT_LT(back.images[0].cam_from_world.rotation.angularDistance(unit), 1e-14);
  EXPECT_NEAR(back.images[0].cam_from_world.rotation.norm(), 1, 1e-15);
  EXPECT_THAT(back.warnings, ::testing::ElementsAre(HasSubstr("1 image rotations")));
}

TEST(BinaryModel, ImagesThatContradictTheModelAreRefused) {
  SparseModel model = MakeModel();
  model.images[2].camera_id = 5;
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("image 5 (b.png) refers to camera 5, which is not"));
  model = MakeModel();
  model.images[2].id = 9;
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("image 9 is defined twice"));
  model = MakeModel();
  model.images[2].name = "c.png";
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("image name \"c.png\" occurs twice"));
}

TEST(BinaryModel, NamesThatLeadOutOfTheFolderAreRefused) {
  for (const char* name : {"", "/etc/passwd", "../a.png", "a/../../b.png"}) {
    SparseModel model = MakeModel();
    model.images[0].name = name;
    EXPECT_THAT(ErrorOfBinary(model), HasSubstr("images.bin: byte 8: image 9: ")) << name;
  }
  SparseModel model = MakeModel();
  model.images[0].name = "a/..b.png";
  EXPECT_EQ(ErrorOfBinary(model), "");
  model.images[0].name = std::string(5000, 'a');
  EXPECT_THAT(ErrorOfBinary(model), HasSubstr("longer than 4096 bytes"));
}

TEST(BinaryModel, BadPointsAreLeftOutAndCounted) {
  SparseModel model = MakeModel();
  model.points[0].position.x() = std::nan("");
  model.points.push_back(model.points[1]);
  model.points[1].track.push_back({77, 0});
  const SparseModel back = ReadBinary(Write(model));
  ASSERT_EQ(back.points.size(), 1u);
  EXPECT_EQ(back.points[0].track.size(), 1u);
  EXPECT_THAT(back.warnings, ::testing::ElementsAre(HasSubstr("2 3D points left out"),
                                                    HasSubstr("1 elements of point tracks")));
}

}  // namespace
}  // namespace limn::colmap_ext
