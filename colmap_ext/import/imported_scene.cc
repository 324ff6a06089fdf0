// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/imported_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "colmap_ext/model/model_builder.h"

namespace limn::colmap_ext {
namespace {

void ShiftPixels(double shift, ImportedImage* image) {
  Camera& camera = image->camera;
  const int num_focals = FindCameraModel(static_cast<int32_t>(camera.model))->num_focals;
  camera.params[num_focals] += shift;
  camera.params[num_focals + 1] += shift;
  for (Observation& observation : image->observations) observation.position.array() += shift;
}

// How far the two cameras can have the same ray apart along one axis, pixels.
double Difference(double focal_a, double center_a, double focal_b, double center_b, double size) {
  const double reach = std::max(std::abs(center_a), std::abs(size - center_a));
  return std::abs(center_a - center_b) + std::abs(focal_a - focal_b) / focal_a * reach;
}

bool IsSame(const Camera& camera_a, const Camera& camera_b, double tolerance_px) {
  if (camera_a.model != camera_b.model || camera_a.width != camera_b.width ||
      camera_a.height != camera_b.height) {
    return false;
  }
  const Intrinsics a = IntrinsicsOf(camera_a);
  const Intrinsics b = IntrinsicsOf(camera_b);
  const auto close = [](double p, double q) { return std::abs(p - q) <= 1e-10; };
  return Difference(a.fx, a.cx, b.fx, b.cx, static_cast<double>(camera_a.width)) <= tolerance_px &&
         Difference(a.fy, a.cy, b.fy, b.cy, static_cast<double>(camera_a.height)) <= tolerance_px &&
         std::equal(a.extra.begin(), a.extra.end(), b.extra.begin(), b.extra.end(), close);
}

// Numbers the cameras, one for all images that share it; returns their first images.
std::vector<const ImportedImage*> NumberCameras(std::vector<ImportedImage>* images,
                                                double tolerance_px) {
  std::vector<const ImportedImage*> first_images;
  for (ImportedImage& image : *images) {
    const auto shared =
        std::find_if(first_images.begin(), first_images.end(), [&](const ImportedImage* first) {
          return IsSame(first->camera, image.camera, tolerance_px);
        });
    if (shared != first_images.end()) {
      image.camera.id = (*shared)->camera.id;
      continue;
    }
    first_images.push_back(&image);
    image.camera.id = static_cast<uint32_t>(first_images.size());
  }
  return first_images;
}

FilePlace PlaceOf(const ImportedImage& image) { return {image.path, image.unit, image.number}; }

}  // namespace

void SetPoints(TrackedPoints tracked, ImportedScene* scene) {
  scene->points = std::move(tracked.points);
  for (size_t i = 0; i < tracked.observations.size(); ++i) {
    scene->images[i].observations = std::move(tracked.observations[i]);
  }
}

SparseModel ToSparseModel(ImportedScene scene, const SparseModelOptions& options) {
  const double shift = options.pixel_centers == PixelCenters::kInteger ? 0.5 : 0.0;
  for (ImportedImage& image : scene.images) ShiftPixels(shift, &image);
  ModelBuilder builder;
  for (const ImportedImage* image : NumberCameras(&scene.images, options.share_cameras_px)) {
    builder.AddCamera(image->camera, PlaceOf(*image));
  }
  for (size_t i = 0; i < scene.images.size(); ++i) {
    ImportedImage& imported = scene.images[i];
    ModelImage image;
    image.id = static_cast<uint32_t>(i + 1);
    image.cam_from_world = imported.cam_from_world;
    image.camera_id = imported.camera.id;
    image.name = imported.name;
    image.observations = std::move(imported.observations);
    const Eigen::Quaterniond& q = image.cam_from_world.rotation;
    const std::array<double, 4> wxyz = {q.w(), q.x(), q.y(), q.z()};
    builder.AddImage(std::move(image), wxyz, PlaceOf(imported));
  }
  for (ModelPoint& point : scene.points) builder.AddPoint(std::move(point));
  return builder.Finish();
}

}  // namespace limn::colmap_ext
