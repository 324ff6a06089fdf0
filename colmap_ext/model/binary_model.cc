// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <utility>

#include "colmap_ext/model/model_files.h"
#include "colmap_ext/model/record_reading.h"

namespace limn::colmap_ext {
namespace {

// Sizes of the fixed parts of records, bytes.
constexpr uint64_t kCameraBytes = 24;
constexpr uint64_t kImageBytes = 64 + 1 + 8;  // with an empty name and no points
constexpr uint64_t kObservationBytes = 24;
constexpr uint64_t kPointBytes = 51;
constexpr uint64_t kTrackElementBytes = 8;

Eigen::Vector3d ReadVector3(ByteReader& reader, const char* what) {
  const auto xyz = reader.Get<std::array<double, 3>>(what);
  return {xyz[0], xyz[1], xyz[2]};
}

std::vector<Observation> ReadObservations(ByteReader& reader) {
  const uint64_t count = ReadCount(reader, "number of 2D points", kObservationBytes);
  std::vector<Observation> observations(count);
  for (Observation& observation : observations) {
    const auto xy = reader.Get<std::array<double, 2>>("a 2D point");
    observation.position = {xy[0], xy[1]};
    observation.point3D_id = reader.Get<uint64_t>("a 2D point's point3D_id");
  }
  return observations;
}

}  // namespace

void ReadCamerasBinary(std::istream& in, const std::string& path, ModelBuilder* builder) {
  ByteReader reader(path, in);
  const uint64_t count = ReadCount(reader, "number of cameras", kCameraBytes);
  for (uint64_t i = 0; i < count; ++i) {
    const FilePlace place = reader.Here();
    Camera camera;
    camera.id = reader.Get<uint32_t>("camera_id");
    const auto model_id = reader.Get<int32_t>("model_id");
    const CameraModel* model = FindCameraModel(model_id);
    if (!model) {
      place.Fail("camera " + std::to_string(camera.id) + " has the unknown camera model id " +
                 std::to_string(model_id) + "; supported: " + SupportedCameraModels());
    }
    camera.model = model->id;
    camera.width = reader.Get<uint64_t>("width");
    camera.height = reader.Get<uint64_t>("height");
    camera.params.resize(model->num_params);
    reader.GetArray(camera.params.data(), camera.params.size(), "camera parameters");
    builder->AddCamera(std::move(camera), place);
  }
  reader.ExpectEnd();
}

void ReadImagesBinary(std::istream& in, const std::string& path, ModelBuilder* builder) {
  ByteReader reader(path, in);
  const uint64_t count = ReadCount(reader, "number of images", kImageBytes);
  for (uint64_t i = 0; i < count; ++i) {
    const FilePlace place = reader.Here();
    ModelImage image;
    image.id = reader.Get<uint32_t>("image_id");
    const auto quaternion = reader.Get<std::array<double, 4>>("rotation");
    image.cam_from_world.translation = ReadVector3(reader, "translation");
    image.camera_id = reader.Get<uint32_t>("camera_id");
    image.name = ReadName(reader, "image name");
    image.observations = ReadObservations(reader);
    builder->AddImage(std::move(image), quaternion, place);
  }
  reader.ExpectEnd();
}

void ReadPointsBinary(std::istream& in, const std::string& path, ModelBuilder* builder) {
  ByteReader reader(path, in);
  const uint64_t count = ReadCount(reader, "number of 3D points", kPointBytes);
  for (uint64_t i = 0; i < count; ++i) {
    ModelPoint point;
    point.id = reader.Get<uint64_t>("point3D_id");
    point.position = ReadVector3(reader, "position of a 3D point");
    point.color = reader.Get<std::array<uint8_t, 3>>("color");
    point.error = reader.Get<double>("error");
    point.track.resize(ReadCount(reader, "track length", kTrackElementBytes));
    for (TrackElement& element : point.track) {
      element.image_id = reader.Get<uint32_t>("a track's image_id");
      element.observation = reader.Get<uint32_t>("a track's point2D_idx");
    }
    builder->AddPoint(std::move(point));
  }
  reader.ExpectEnd();
}

}  // namespace limn::colmap_ext
