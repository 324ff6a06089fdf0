// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/openmvg.h"

#include <nlohmann/json.hpp>

#include "colmap_ext/import/import_test_base.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

constexpr char kOpenmvgFormat[] = "openmvg";
constexpr uint32_t kFirstOfType = 2147483648;

Json Behind(const Json& data) { return {{"id", 1}, {"data", data}}; }

Json IntrinsicOf(const char* type, const std::vector<double>& focal_and_center, const Json& lens) {
  Json data = {{"width", 640},
               {"height", 480},
               {"focal_length", focal_and_center[0]},
               {"principal_point", {focal_and_center[1] - 0.5, focal_and_center[2] - 0.5}}};
  data.update(lens);
  return {{"polymorphic_id", kFirstOfType + 1},
          {"polymorphic_name", type},
          {"ptr_wrapper", Behind(data)}};
}

// Pixels of a model are half a pixel from those of openMVG.
Json FileOf(const SparseModel& model, const Json& intrinsic) {
  Json file = {{"sfm_data_version", "0.3"}, {"root_path", "/elsewhere/images"}};
  Json same_type = intrinsic;
  same_type.erase("polymorphic_name");
  same_type["polymorphic_id"] = 1;
  file["intrinsics"] = {{{"key", 0}, {"value", intrinsic}}, {{"key", 7}, {"value", same_type}}};
  for (const ModelImage& image : model.images) {
    const Eigen::Matrix3d r = image.cam_from_world.rotation.toRotationMatrix();
    const Eigen::Vector3d c = Inverse(image.cam_from_world).translation;
    const Json view = {{"local_path", ""},
                       {"filename", image.name},
                       {"width", 640},
                       {"height", 480},
                       {"id_view", image.id},
                       {"id_intrinsic", image.id == 2 ? 7 : 0},
                       {"id_pose", 100 + image.id}};
    file["views"].push_back(
        {{"key", image.id},
         {"value", {{"polymorphic_id", 1073741824}, {"ptr_wrapper", Behind(view)}}}});
    file["extrinsics"].push_back({{"key", 100 + image.id},
                                  {"value",
                                   {{"rotation",
                                     {{r(0, 0), r(0, 1), r(0, 2)},
                                      {r(1, 0), r(1, 1), r(1, 2)},
                                      {r(2, 0), r(2, 1), r(2, 2)}}},
                                    {"center", {c.x(), c.y(), c.z()}}}}});
  }
  for (const ModelPoint& point : model.points) {
    Json observations = Json::array();
    for (const TrackElement& element : point.track) {
      const Eigen::Vector2d px =
          model.images[element.image_id - 1].observations[element.observation].position;
      observations.push_back({{"key", element.image_id},
                              {"value", {{"id_feat", 3}, {"x", {px.x() - 0.5, px.y() - 0.5}}}}});
    }
    const Eigen::Vector3d& x = point.position;
    file["structure"].push_back(
        {{"key", point.id},
         {"value", {{"X", {x.x(), x.y(), x.z()}}, {"observations", observations}}}});
  }
  return file;
}

class Openmvg : public ImportTest {
 protected:
  std::string Write(const Json& json) { return dir_.WriteFile("sfm_data.json", json.dump()); }
  SparseModel ImportInteger(const std::string& path) {
    Arguments arguments;
    arguments.pixel_centers = PixelCenters::kInteger;
    return Import(kOpenmvgFormat, path, arguments);
  }

  // With the principal point off the center.
  static SparseModel Known(CameraModelId id, const std::vector<double>& params) {
    SparseModel model = KnownModel();
    model.cameras[0].model = id;
    model.cameras[0].params = params;
    return model;
  }
};

TEST_F(Openmvg, GivesTheSameProjections) {
  const auto expect = [&](CameraModelId id, const std::vector<double>& params, const char* type,
                          const Json& lens) {
    const SparseModel expected = Known(id, params);
    const bool has_two = FindCameraModel(static_cast<int32_t>(id))->num_focals == 2;
    const Json intrinsic =
        IntrinsicOf(type, {params[0], params[has_two ? 2 : 1], params[has_two ? 3 : 2]}, lens);
    const SparseModel model = Import(kOpenmvgFormat, Write(FileOf(expected, intrinsic)));
    ExpectSameProjections(model, expected);
    EXPECT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.cameras[0].model, id);
  };
  expect(CameraModelId::kSimplePinhole, {600, 316.75, 251.125}, "pinhole", Json::object());
  expect(CameraModelId::kSimpleRadial, {600, 316.75, 251.125, -0.1}, "pinhole_radial_k1",
         {{"disto_k1", {-0.1}}});
  expect(CameraModelId::kFullOpencv, {600, 600, 316.75, 251.125, -0.1, 0.05, 0, 0, 0.01, 0, 0, 0},
         "pinhole_radial_k3", {{"disto_k3", {-0.1, 0.05, 0.01}}});
  expect(CameraModelId::kFullOpencv,
         {600, 600, 316.75, 251.125, -0.1, 0.05, 0.001, -0.002, 0.01, 0, 0, 0}, "pinhole_brown_t2",
         {{"disto_t2", {-0.1, 0.05, 0.01, 0.001, -0.002}}});
  expect(CameraModelId::kOpencvFisheye, {600, 600, 316.75, 251.125, -0.02, 0.005, -0.003, 0.0005},
         "fisheye", {{"fisheye", {-0.02, 0.005, -0.003, 0.0005}}});
}

TEST_F(Openmvg, KeepsPointsAndMeasurements) {
  SparseModel centered = CenteredModel();
  for (ModelPoint& point : centered.points) point.color = {};
  const std::vector<double>& p = centered.cameras[0].params;
  ExpectSamePoints(
      Import(kOpenmvgFormat, Write(FileOf(centered, IntrinsicOf("pinhole", p, Json::object())))),
      centered);
}

TEST_F(Openmvg, ViewsWithoutPoseAreLeftOut) {
  const SparseModel known = KnownModel();
  Json file = FileOf(known, IntrinsicOf("pinhole", {600, 320, 240}, Json::object()));
  file["extrinsics"].erase(1);
  EXPECT_EQ(Import(kOpenmvgFormat, Write(file)).images.size(), 2u);
  EXPECT_THAT(notes_, Contains("1 views have no pose and are left out"));
}

TEST_F(Openmvg, NullsCountAsMissing) {
  const SparseModel centered = CenteredModel();
  Json file = FileOf(centered, IntrinsicOf("pinhole", centered.cameras[0].params, Json::object()));
  file["root_path"] = file["structure"] = nullptr;
  file["views"][0]["value"]["ptr_wrapper"]["data"]["local_path"] = nullptr;
  ExpectSameProjections(Import(kOpenmvgFormat, Write(file)), centered);
}

TEST_F(Openmvg, BadFilesAreRefused) {
  const SparseModel centered = CenteredModel();
  const Json good =
      FileOf(centered, IntrinsicOf("pinhole", centered.cameras[0].params, Json::object()));
  const auto error_at = [&](const char* pointer, const Json& value) {
    Json file = good;
    file[Json::json_pointer(pointer)] = value;
    const std::string error = Error(kOpenmvgFormat, Write(file));
    EXPECT_THAT(error, AllOf(HasSubstr("sfm_data.json: "), Not(HasSubstr("exception")))) << pointer;
    return error;
  };
  EXPECT_THAT(error_at("/views", 7), HasSubstr("sfm_data.json: views: a list expected"));
  EXPECT_THAT(error_at("/views/1/value", 7), HasSubstr("views[1].value: an object expected"));
  EXPECT_THAT(
      error_at("/views/1/value/ptr_wrapper/data/id_pose", -1),
      HasSubstr("views[1].value.ptr_wrapper.data.id_pose: an integer from 0 to 2^53 expected"));
  EXPECT_THAT(error_at("/views/1/value/ptr_wrapper/data/filename", "none.png"),
              HasSubstr("image \"none.png\" is not in the image folder"));
  EXPECT_THAT(error_at("/extrinsics/2/value/rotation/0/0", 9), HasSubstr("pose 2: the rotation"));
  EXPECT_THAT(error_at("/extrinsics/2/value/rotation", {1}),
              HasSubstr("extrinsics[2].value.rotation: a list of 3 expected, not of 1"));
  EXPECT_THAT(error_at("/intrinsics/0/value/polymorphic_name", "spherical"),
              HasSubstr("view 0: cameras of type \"spherical\" are not read"));
  EXPECT_THAT(error_at("/intrinsics/0/value/polymorphic_name", nullptr),
              HasSubstr("intrinsics[0].value: no camera before it"));
  EXPECT_THAT(error_at("/intrinsics/0/value/ptr_wrapper/data/width", 100),
              HasSubstr("another aspect"));
  EXPECT_THAT(error_at("/structure/0/value/X", {1, 2}),
              HasSubstr("structure[0].value.X: a list of 3 numbers expected"));
  EXPECT_THAT(error_at("/structure/0/value/observations/0/value/x/0", "a"),
              HasSubstr("structure[0].value.observations[0].value.x[0]: a number expected"));
  EXPECT_THAT(Error(kOpenmvgFormat, dir_.WriteFile("sfm_data.json", "{\"sfm_data_version\": ")),
              HasSubstr("the JSON text ends too early"));
}

}  // namespace
}  // namespace limn::colmap_ext
