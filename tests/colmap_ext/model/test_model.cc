// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/test_model.h"

#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

using Id = CameraModelId;

const std::map<Id, std::vector<double>>& ExtraParams() {
  static const std::map<Id, std::vector<double>> extra = {
      {Id::kSimplePinhole, {}},
      {Id::kPinhole, {}},
      {Id::kSimpleRadial, {-0.08}},
      {Id::kRadial, {-0.1, 0.03}},
      {Id::kOpencv, {-0.12, 0.04, 0.001, -0.002}},
      {Id::kOpencvFisheye, {-0.02, 0.005, -0.003, 0.0005}},
      {Id::kFullOpencv, {0.1, 0.05, 0.001, -0.0015, 0.01, 0.2, 0.06, 0.008}},
      {Id::kFov, {0.9}},
      {Id::kSimpleRadialFisheye, {-0.03}},
      {Id::kRadialFisheye, {-0.03, 0.004}},
      {Id::kThinPrismFisheye, {-0.02, 0.004, 0.001, -0.0012, 0.001, -0.0003, 0.002, -0.001}},
      {Id::kRadTanThinPrismFisheye,
       {0.02, -0.03, 0.01, -0.004, 0.001, -0.0001, 0.001, -0.002, 0.001, -0.0005, 0.0008, 0.0003}},
      {Id::kSimpleDivision, {-0.2}},
      {Id::kDivision, {-0.15}},
      {Id::kSimpleFisheye, {}},
      {Id::kFisheye, {}},
      {Id::kEucm, {0.6, 1.1}},
  };
  return extra;
}

ModelImage MakeImage(uint32_t id, uint32_t camera_id, const std::string& name, double angle_rad) {
  ModelImage image;
  image.id = id;
  image.camera_id = camera_id;
  image.name = name;
  image.cam_from_world.rotation =
      Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, 2, -1).normalized());
  image.cam_from_world.translation = {0.1 * id, -0.25, 3.0 + angle_rad};
  return image;
}

}  // namespace

Camera MakeCamera(CameraModelId model, uint32_t id) {
  Camera camera;
  camera.id = id;
  camera.model = model;
  camera.width = 800;
  camera.height = 600;
  const int num_focals = FindCameraModel(static_cast<int32_t>(model))->num_focals;
  camera.params = {500.5, 403.25, 297.75};
  if (num_focals == 2) camera.params = {500.5, 510.25, 403.25, 297.75};
  const std::vector<double>& extra = ExtraParams().at(model);
  camera.params.insert(camera.params.end(), extra.begin(), extra.end());
  return camera;
}

SparseModel MakeModel() {
  SparseModel model;
  for (const uint32_t id : {7u, 3u}) {
    Camera camera;
    camera.id = id;
    camera.width = 800;
    camera.height = 600;
    camera.params = {500.0 + id, 510.0 + id, 400, 300};
    model.cameras.push_back(camera);
  }
  model.images = {MakeImage(9, 3, "c.png", 0.1), MakeImage(4, 7, "sub/a b.png", -0.4),
                  MakeImage(5, 3, "b.png", 1.3)};
  model.images[0].observations = {{{10.25, 20.5}, 1000}, {{700.1, 5.0 / 3.0}, kNoPoint3D}};
  model.images[2].observations = {{{33, 44}, 1000}, {{55.5, 66.125}, 2}};
  model.points = {{1000, {0.1, -0.2, 1.0 / 3.0}, {1, 2, 255}, 0.75, {{9, 0}, {5, 0}}},
                  {2, {-1e-3, 7, 12}, {0, 0, 0}, -1, {{5, 1}}}};
  return model;
}

void ExpectSameModel(const SparseModel& actual, const SparseModel& expected) {
  ASSERT_EQ(actual.cameras.size(), expected.cameras.size());
  for (size_t i = 0; i < expected.cameras.size(); ++i) {
    EXPECT_EQ(actual.cameras[i].id, expected.cameras[i].id);
    EXPECT_EQ(actual.cameras[i].model, expected.cameras[i].model);
    EXPECT_EQ(actual.cameras[i].width, expected.cameras[i].width);
    EXPECT_EQ(actual.cameras[i].height, expected.cameras[i].height);
    EXPECT_EQ(actual.cameras[i].params, expected.cameras[i].params);
  }
  ASSERT_EQ(actual.images.size(), expected.images.size());
  for (size_t i = 0; i < expected.images.size(); ++i) {
    const ModelImage& a = actual.images[i];
    const ModelImage& e = expected.images[i];
    EXPECT_EQ(a.id, e.id);
    EXPECT_EQ(a.camera_id, e.camera_id);
    EXPECT_EQ(a.name, e.name);
    EXPECT_LT(a.cam_from_world.rotation.angularDistance(e.cam_from_world.rotation), 1e-14);
    EXPECT_EQ(a.cam_from_world.translation, e.cam_from_world.translation);
    ASSERT_EQ(a.observations.size(), e.observations.size());
    for (size_t k = 0; k < e.observations.size(); ++k) {
      EXPECT_EQ(a.observations[k].position, e.observations[k].position);
      EXPECT_EQ(a.observations[k].point3D_id, e.observations[k].point3D_id);
    }
  }
  ASSERT_EQ(actual.points.size(), expected.points.size());
  for (size_t i = 0; i < expected.points.size(); ++i) {
    const ModelPoint& a = actual.points[i];
    const ModelPoint& e = expected.points[i];
    EXPECT_EQ(a.id, e.id);
    EXPECT_EQ(a.position, e.position);
    EXPECT_EQ(a.color, e.color);
    EXPECT_EQ(a.error, e.error);
    ASSERT_EQ(a.track.size(), e.track.size());
    for (size_t k = 0; k < e.track.size(); ++k) {
      EXPECT_EQ(a.track[k].image_id, e.track[k].image_id);
      EXPECT_EQ(a.track[k].observation, e.track[k].observation);
    }
  }
}

bool HaveColmap() { return std::system("colmap help > /dev/null 2>&1") == 0; }

bool RunColmap(const std::string& arguments, const std::filesystem::path& log) {
  const std::string command =
      "QT_QPA_PLATFORM=offscreen colmap " + arguments + " > '" + log.string() + "' 2>&1";
  return std::system(command.c_str()) == 0;
}

}  // namespace limn::colmap_ext
