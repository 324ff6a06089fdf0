// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/nerf_transforms.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/import_test_base.h"
#include "colmap_ext/import/model_import.h"
#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/workspace/find_masks.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr char kNerfTransformsFormat[] = "nerf_transforms";

// world_from_cam with y up and z backwards.
Json Transform(const Rigid3d& cam_from_world) {
  const Rigid3d world_from_cam = Inverse(cam_from_world);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() =
      world_from_cam.rotation.toRotationMatrix() * Eigen::DiagonalMatrix<double, 3>(1, -1, -1);
  matrix.topRightCorner<3, 1>() = world_from_cam.translation;
  Json json;
  for (int row = 0; row < 4; ++row) {
    json.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
  }
  return json;
}

Json Frames(const SparseModel& model) {
  Json frames;
  for (const ModelImage& image : model.images) {
    frames.push_back({{"file_path", "./images/" + image.name},
                      {"transform_matrix", Transform(image.cam_from_world)}});
  }
  return frames;
}

// All parameters at the top of the file.
Json File(const SparseModel& model) {
  const std::vector<double>& params = model.cameras[0].params;
  return {{"fl_x", params[0]}, {"fl_y", params[1]}, {"cx", params[2]},        {"cy", params[3]},
          {"w", 640},          {"h", 480},          {"frames", Frames(model)}};
}

class NerfTransforms : public ImportTest {
 protected:
  std::string Write(const Json& json) { return dir_.WriteFile("transforms.json", json.dump()); }
  std::string ErrorWith(const Json& json) { return Error(kNerfTransformsFormat, Write(json)); }

  const SparseModel known_ = KnownModel();
};

TEST_F(NerfTransforms, GiveTheSameProjections) {
  Write(File(known_));
  const SparseModel model = Import(kNerfTransformsFormat, dir_.path());
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kPinhole);
}

TEST_F(NerfTransforms, MasksOfFramesAreListed) {
  Json file = File(known_);
  file["frames"][0]["mask_path"] = "masks\\one.png";
  file["frames"][2]["mask_path"] = "./masks/three.png";
  dir_.WriteFile("masks/one.png", "");
  dir_.WriteFile("masks/three.png", "");
  ImporterOptions options;
  options.input_path = Write(file);
  options.image_path = images_;
  std::vector<std::string> notes;
  const ImportedModel imported = ImportModel(options, &notes);
  EXPECT_THAT(notes, Contains(HasSubstr("2 of 3 images have masks")));
  WriteNewModel(imported.model, dir_ / "sparse/0", ModelFlavor::kBinary, [&](const OutputPath& to) {
    WriteMaskList(imported.masks, dir_ / "sparse/0", to);
  });
  const std::string list = MaskListOf(dir_ / "sparse/0");
  const FoundMasks found = FindMasks(list, imported.model, {0, 1, 2}, {"", "", ""});
  EXPECT_EQ(found.paths[0], fs::canonical(dir_ / "masks/one.png").string());
  EXPECT_EQ(found.paths[1], "");
  file["frames"][1]["mask_path"] = "masks/two.png";
  EXPECT_THAT(ErrorWith(file), HasSubstr("frame 1: mask \"masks/two.png\" is missing"));
  file["frames"][1]["mask_path"] = 7;
  EXPECT_THAT(ErrorWith(file), HasSubstr("frames[1].mask_path: a text expected"));
}

TEST_F(NerfTransforms, CameraAnglesAreForTheWholeImage) {
  Json file = {{"frames", Frames(known_)}};
  file["camera_angle_x"] = 2 * std::atan(320 / 600.25);
  ExpectSameProjections(Import(kNerfTransformsFormat, Write(file)), CenteredModel());
  SparseModel expected = KnownModel();
  expected.cameras[0].params = {600.25, 611.5, 320, 240};
  file["camera_angle_y"] = 2 * std::atan(240 / 611.5);
  ExpectSameProjections(Import(kNerfTransformsFormat, Write(file)), expected);
}

TEST_F(NerfTransforms, FramesMayHaveIntrinsicsOfTheirOwn) {
  Json file = File(known_);
  file["frames"][2]["fl_x"] = 555.5;
  file["frames"][2]["k1"] = -0.05;
  SparseModel expected = known_;
  expected.cameras.push_back(expected.cameras[0]);
  expected.cameras[1].id = 2;
  expected.cameras[1].model = CameraModelId::kOpencv;
  expected.cameras[1].params = {555.5, 611.5, 316.75, 251.125, -0.05, 0, 0, 0};
  expected.images[2].camera_id = 2;
  const SparseModel model = Import(kNerfTransformsFormat, Write(file));
  ExpectSameProjections(model, expected);
  EXPECT_EQ(model.cameras.size(), 2u);
}

TEST_F(NerfTransforms, NullsCountAsMissing) {
  Json file = File(known_);
  for (const char* key : {"k1", "camera_model", "is_fisheye", "from_na"}) file[key] = nullptr;
  for (const char* key : {"fl_x", "mask_path"}) file["frames"][2][key] = nullptr;
  ExpectSameProjections(Import(kNerfTransformsFormat, Write(file)), known_);
}

// The models of other tests, with k1 ... as the file has them.
TEST_F(NerfTransforms, LensesBecomeColmaps) {
  const auto expect = [&](CameraModelId id, const std::vector<double>& extra, Json lens) {
    SparseModel expected = known_;
    expected.cameras[0].model = id;
    expected.cameras[0].params.insert(expected.cameras[0].params.end(), extra.begin(), extra.end());
    lens.update(File(known_));
    const SparseModel model = Import(kNerfTransformsFormat, Write(lens));
    EXPECT_EQ(model.cameras[0].model, id);
    ExpectSameProjections(model, expected);
  };
  expect(CameraModelId::kOpencv, {-0.12, 0.04, 0.001, -0.002},
         {{"k1", -0.12}, {"k2", 0.04}, {"p1", 0.001}, {"p2", -0.002}, {"camera_model", "OPENCV"}});
  expect(CameraModelId::kFullOpencv, {-0.12, 0.04, 0.001, -0.002, 0.01, 0, 0, 0},
         {{"k1", -0.12}, {"k2", 0.04}, {"k3", 0.01}, {"p1", 0.001}, {"p2", -0.002}});
  const Json fisheye = {{"k1", -0.02}, {"k2", 0.005}, {"k3", -0.003}, {"k4", 0.0005}};
  for (const Json& flag : {Json{{"camera_model", "OPENCV_FISHEYE"}}, Json{{"is_fisheye", true}}}) {
    Json lens = fisheye;
    lens.update(flag);
    expect(CameraModelId::kOpencvFisheye, {-0.02, 0.005, -0.003, 0.0005}, lens);
  }
}

// As nerfstudio's images_4 beside the cameras of full size.
TEST_F(NerfTransforms, ImagesMayBeShrunk) {
  Json file = File(known_);
  for (const char* key : {"w", "h", "fl_x", "fl_y", "cx", "cy"}) {
    file[key] = 4 * file[key].get<double>();
  }
  SparseModel expected = known_;
  expected.cameras[0].width *= 4;
  expected.cameras[0].height *= 4;
  for (double& parameter : expected.cameras[0].params) parameter *= 4;
  const SparseModel model = Import(kNerfTransformsFormat, Write(file));
  ExpectSameProjections(model, expected);
  EXPECT_EQ(model.cameras[0].width, 2560u);
}

TEST_F(NerfTransforms, ThatPointsAreNotReadIsSaid) {
  Json file = File(known_);
  file["ply_file_path"] = "points.ply";
  EXPECT_TRUE(Import(kNerfTransformsFormat, Write(file)).points.empty());
  EXPECT_THAT(notes_, Contains("The points of its .ply are not read"));
}

TEST_F(NerfTransforms, NamesWithoutExtensionArePng) {
  Json file = File(known_);
  file["frames"][0]["file_path"] = "images/img_1";
  ExpectSameProjections(Import(kNerfTransformsFormat, Write(file)), known_);
}

TEST_F(NerfTransforms, BadFilesAreRefused) {
  const auto error_with = [&](const char* key, const Json& value) {
    Json file = File(known_);
    file["frames"][1][key] = value;
    const std::string error = ErrorWith(file);
    EXPECT_THAT(error, AnyOf(HasSubstr("transforms.json: frame 1: "),
                             HasSubstr("transforms.json: frames[1]." + std::string(key))))
        << key;
    return error;
  };
  EXPECT_THAT(error_with("file_path", "images/none.png"),
              HasSubstr("image \"images/none.png\" is not in the image folder"));
  EXPECT_THAT(error_with("file_path", 7), HasSubstr("frames[1].file_path: a text expected"));
  EXPECT_THAT(error_with("w", 700), HasSubstr("image \"img_2.png\" has 640 x 480 pixels, but width "
                                              "and height are 700 and 480: another aspect"));
  EXPECT_THAT(error_with("k4", -50), HasSubstr("the radial distortion with k4 = -50"));
  EXPECT_THAT(error_with("camera_model", "EQUIRECTANGULAR"),
              HasSubstr("frames[1].camera_model: unknown camera model \"EQUIRECTANGULAR\""));
  EXPECT_THAT(error_with("fl_x", -600), HasSubstr("the focal length is not positive"));
  EXPECT_THAT(error_with("fl_x", "600"), HasSubstr("frames[1].fl_x: a number expected"));
  EXPECT_THAT(error_with("transform_matrix", {{1, 0, 0, 0}, {0, 1, 0, 0}}),
              HasSubstr("transform_matrix: a list of 3 to 4 expected, not of 2"));
  EXPECT_THAT(error_with("transform_matrix", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1}}),
              HasSubstr("transform_matrix[2]: a list of 4 numbers expected"));
  EXPECT_THAT(error_with("transform_matrix", {{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}),
              HasSubstr("the rotation matrix is none"));
  EXPECT_THAT(
      error_with("transform_matrix", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1}}),
      HasSubstr("transform_matrix: the last row is not 0 0 0 1"));
  Json file = File(known_);
  file["frames"][2].erase("transform_matrix");
  EXPECT_THAT(ErrorWith(file), HasSubstr("frames[2]: no \"transform_matrix\""));
  file = File(known_);
  file.erase("fl_x");
  EXPECT_THAT(ErrorWith(file), HasSubstr("frame 0: neither fl_x nor camera_angle_x"));
  file = File(known_);
  file["from_na"] = true;
  EXPECT_THAT(ErrorWith(file), HasSubstr("transforms.json: from_na: the axes of NeuS2"));
  file["frames"] = 5;
  EXPECT_THAT(ErrorWith(file), HasSubstr("transforms.json: frames: a list expected"));
  EXPECT_THAT(ErrorWith(Json::object()), HasSubstr("transforms.json: no \"frames\""));
  const std::string text = File(known_).dump();
  EXPECT_THAT(Error(kNerfTransformsFormat,
                    dir_.WriteFile("transforms.json", text.substr(0, text.size() / 2))),
              HasSubstr("transforms.json: line 1: "));
  EXPECT_THAT(Error(kNerfTransformsFormat, dir_.WriteFile("transforms.json", "{\"fl_x\": nan}")),
              HasSubstr("transforms.json: line 1: "));
}

}  // namespace
}  // namespace limn::colmap_ext
