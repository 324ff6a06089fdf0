// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <utility>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_files.h"

namespace limn::colmap_ext {
namespace {

Eigen::Vector3d ReadVector3(Fields& fields, const char* what) {
  const double x = fields.Number<double>(what);
  const double y = fields.Number<double>(what);
  const double z = fields.Number<double>(what);
  return {x, y, z};
}

// -1 is how text writes "none".
uint64_t ReadPointId(Fields& fields, const char* what) {
  return static_cast<uint64_t>(fields.Number<int64_t>(what));
}

std::vector<Observation> ReadObservations(Fields& fields) {
  std::vector<Observation> observations;
  while (!fields.AtEnd()) {
    Observation observation;
    const char* what = "X Y POINT3D_ID of a 2D point; is the line of points missing?";
    observation.position.x() = fields.Number<double>(what);
    observation.position.y() = fields.Number<double>(what);
    observation.point3D_id = ReadPointId(fields, what);
    observations.push_back(observation);
  }
  return observations;
}

}  // namespace

void ReadCamerasText(std::istream& in, const std::string& path, ModelBuilder* builder) {
  LineReader reader(in, path);
  while (reader.NextRecord()) {
    Fields fields(reader);
    Camera camera;
    camera.id = fields.Number<uint32_t>("CAMERA_ID");
    const std::string name(fields.Next("MODEL"));
    const CameraModel* model = FindCameraModel(name);
    if (!model) {
      fields.place().Fail("camera " + std::to_string(camera.id) +
                          " has the unknown camera model \"" + name +
                          "\"; supported: " + SupportedCameraModels());
    }
    camera.model = model->id;
    camera.width = fields.Number<uint64_t>("WIDTH");
    camera.height = fields.Number<uint64_t>("HEIGHT");
    while (!fields.AtEnd()) camera.params.push_back(fields.Number<double>("PARAMS"));
    if (static_cast<int>(camera.params.size()) != model->num_params) {
      fields.place().Fail("camera " + std::to_string(camera.id) + ": " + name + " has " +
                          std::to_string(model->num_params) + " parameters, found " +
                          std::to_string(camera.params.size()));
    }
    builder->AddCamera(std::move(camera), fields.place());
  }
}

void ReadImagesText(std::istream& in, const std::string& path, ModelBuilder* builder) {
  LineReader reader(in, path);
  while (reader.NextRecord()) {
    Fields fields(reader);
    const FilePlace place = fields.place();
    ModelImage image;
    image.id = fields.Number<uint32_t>("IMAGE_ID");
    std::array<double, 4> quaternion;
    for (double& q : quaternion) q = fields.Number<double>("QW QX QY QZ");
    image.cam_from_world.translation = ReadVector3(fields, "TX TY TZ");
    image.camera_id = fields.Number<uint32_t>("CAMERA_ID");
    image.name = std::string(fields.Rest());
    // The last line of a file may lack its line feed, and with it an empty line of points.
    if (reader.NextLine()) {
      Fields points(reader);
      image.observations = ReadObservations(points);
    }
    builder->AddImage(std::move(image), quaternion, place);
  }
}

void ReadPointsText(std::istream& in, const std::string& path, ModelBuilder* builder) {
  LineReader reader(in, path);
  while (reader.NextRecord()) {
    Fields fields(reader);
    ModelPoint point;
    point.id = ReadPointId(fields, "POINT3D_ID");
    point.position = ReadVector3(fields, "X Y Z");
    for (uint8_t& channel : point.color) channel = fields.Number<uint8_t>("R G B");
    point.error = fields.Number<double>("ERROR");
    while (!fields.AtEnd()) {
      const auto image_id = fields.Number<uint32_t>("IMAGE_ID of a track");
      const auto observation = fields.Number<uint32_t>("POINT2D_IDX of a track");
      point.track.push_back({image_id, observation});
    }
    builder->AddPoint(std::move(point));
  }
}

}  // namespace limn::colmap_ext
