// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/model_targets.h"

#include "colmap_ext/model/camera_lens_map.h"

namespace limn::fuzz {
namespace {

using namespace colmap_ext;

const std::string kPath = "beside";

void AddCamera(uint32_t id, CameraModelId model, std::vector<double> params,
               ModelBuilder* builder) {
  Camera camera;
  camera.id = id;
  camera.model = model;
  camera.width = 640;
  camera.height = model == CameraModelId::kEquirectangular ? 320 : 480;
  camera.params = std::move(params);
  builder->AddCamera(std::move(camera), {kPath, "line", 1});
}

void AddCameras(ModelBuilder* builder) {
  AddCamera(1, CameraModelId::kPinhole, {500, 500, 320, 240}, builder);
  AddCamera(2, CameraModelId::kEquirectangular, {640, 320}, builder);
}

void AddImages(ModelBuilder* builder) {
  for (const uint32_t id : {1u, 2u}) {
    ModelImage image;
    image.id = id;
    image.camera_id = 1;
    image.name = std::to_string(id) + ".png";
    image.observations.resize(3);
    builder->AddImage(std::move(image), {1, 0, 0, 0}, {kPath, "line", id});
  }
}

// There and back through the lens.
void UseCamera(const Camera& camera) {
  if (camera.IsPanorama()) return;
  const CameraLensMap lens(IntrinsicsOf(camera));
  const Eigen::Vector2d size(static_cast<double>(camera.width), static_cast<double>(camera.height));
  for (const Eigen::Vector2d& at :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1, 1)}) {
    const auto mapped = lens.VirtualFromStored(at.cwiseProduct(size));
    if (mapped) lens.StoredFromVirtual(*mapped);
  }
}

}  // namespace

int FuzzCameras(const uint8_t* data, size_t size, ReadModelFile read) {
  return FuzzStream(data, size, [&](std::istream& in, const std::string& path) {
    ModelBuilder builder;
    read(in, path, &builder);
    for (const Camera& camera : builder.Finish().cameras) UseCamera(camera);
  });
}

int FuzzImages(const uint8_t* data, size_t size, ReadModelFile read) {
  return FuzzStream(data, size, [&](std::istream& in, const std::string& path) {
    ModelBuilder builder;
    AddCameras(&builder);
    read(in, path, &builder);
    builder.Finish();
  });
}

int FuzzPoints(const uint8_t* data, size_t size, ReadModelFile read) {
  return FuzzStream(data, size, [&](std::istream& in, const std::string& path) {
    ModelBuilder builder;
    AddCameras(&builder);
    AddImages(&builder);
    read(in, path, &builder);
    builder.Finish();
  });
}

}  // namespace limn::fuzz
