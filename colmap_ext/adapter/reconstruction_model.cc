// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/adapter/reconstruction_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "colmap_ext/adapter/colmap_versions.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/model/mounted_images.h"

namespace limn::colmap_ext {
namespace {

const std::string kName = "reconstruction";

FilePlace PlaceOf(uint64_t id) { return {kName, "id", id}; }

Camera ToCamera(uint32_t id, const colmap::Camera& from) {
  const CameraModel* model = FindCameraModel(ColmapModelId(from));
  if (!model || ColmapParams(from).size() != static_cast<size_t>(model->num_params)) {
    PlaceOf(id).Fail(
        "the camera has no supported model with its number of parameters; supported: " +
        SupportedCameraModels());
  }
  Camera camera;
  camera.id = id;
  camera.model = model->id;
  camera.params = ColmapParams(from);
  std::tie(camera.width, camera.height) = ColmapSize(from);
  return camera;
}

ModelImage ToImage(uint32_t id, const colmap::Image& from) {
  ModelImage image;
  image.id = id;
  image.camera_id = from.CameraId();
  image.name = from.Name();
  image.cam_from_world = ColmapPose(from);
  for (const auto& point : from.Points2D()) {
    image.observations.push_back({ColmapPixel(point), ColmapPointId(point)});
  }
  return image;
}

ModelPoint ToPoint(uint64_t id, const colmap::Point3D& from) {
  ModelPoint point;
  point.id = id;
  VisitColmapPoint(from, [&](const auto& xyz, const auto& color, double error, const auto& track) {
    point.position = xyz;
    point.color = {color[0], color[1], color[2]};
    point.error = error;
    for (const auto& element : track.Elements()) {
      point.track.push_back({element.image_id, element.point2D_idx});
    }
  });
  return point;
}

// Of a hash table.
template <class Table>
auto SortedIds(const Table& table) {
  std::set<typename Table::key_type> ids;
  for (const auto& entry : table) ids.insert(entry.first);
  return ids;
}

Rigid3d CheckedPose(const Rigid3d& pose, const char* what, uint32_t id) {
  const Eigen::Quaterniond& q = pose.rotation;
  return MakePose({q.w(), q.x(), q.y(), q.z()}, pose.translation, what + std::to_string(id),
                  PlaceOf(id));
}

// What the reader does with those of files.
void UseRigs(SparseModel* model) {
  if (model->rigs.empty()) return;
  for (Rig& rig : model->rigs) {
    for (RigSensor& sensor : rig.sensors) {
      if (!sensor.has_pose) continue;
      sensor.sensor_from_rig = CheckedPose(sensor.sensor_from_rig, "rig ", rig.id);
    }
  }
  for (Frame& frame : model->frames) {
    frame.rig_from_world = CheckedPose(frame.rig_from_world, "frame ", frame.id);
  }
  ApplyRigs(model);
}

bool IsUnit(const Eigen::Quaterniond& rotation) {
  return std::abs(rotation.norm() - 1) <= 4 * std::numeric_limits<double>::epsilon();
}

}  // namespace

SparseModel ToSparseModel(const colmap::Reconstruction& reconstruction) {
  ModelBuilder builder;
  for (const auto id : SortedIds(reconstruction.Cameras())) {
    builder.AddCamera(ToCamera(id, reconstruction.Camera(id)), PlaceOf(id));
  }
  // Normalized once is not always normalized twice, to the last bit.
  std::map<uint32_t, Eigen::Quaterniond> unit_rotations;
  const auto& registered = reconstruction.RegImageIds();
  for (const auto id : std::set<uint32_t>(registered.begin(), registered.end())) {
    const colmap::Image& from = reconstruction.Image(id);
    ModelImage image = ToImage(id, from);
    const Eigen::Quaterniond q = image.cam_from_world.rotation;
    if (ReadsUnitRotations(from) && IsUnit(q)) unit_rotations[id] = q;
    builder.AddImage(std::move(image), {q.w(), q.x(), q.y(), q.z()}, PlaceOf(id));
  }
  for (const auto id : SortedIds(reconstruction.Points3D())) {
    builder.AddPoint(ToPoint(id, reconstruction.Point3D(id)));
  }
  SparseModel model = builder.Finish();
  model.folder = kName;
  AddColmapRigs(reconstruction, &model);
  UseRigs(&model);
  for (ModelImage& image : model.images) {
    const auto unit = unit_rotations.find(image.id);
    if (unit != unit_rotations.end()) image.cam_from_world.rotation = unit->second;
  }
  return model;
}

void AppendPoints(const SparseModel& model, size_t first, colmap::Reconstruction* reconstruction) {
  for (const ModelImage& from : model.images) {
    colmap::Image& image = reconstruction->Image(from.id);
    std::vector<Eigen::Vector2d> pixels;
    for (size_t i = image.NumPoints2D(); i < from.observations.size(); ++i) {
      pixels.push_back(from.observations[i].position);
    }
    AddColmapPixels(pixels, &image);
  }
  for (size_t p = first; p < model.points.size(); ++p) {
    const ModelPoint& point = model.points[p];
    colmap::Track track;
    for (const TrackElement& element : point.track) {
      track.AddElement(element.image_id, element.observation);
    }
    const auto id = reconstruction->AddPoint3D(
        point.position, std::move(track),
        Eigen::Vector3ub(point.color[0], point.color[1], point.color[2]));
    SetColmapError(point.error, &reconstruction->Point3D(id));
  }
}

}  // namespace limn::colmap_ext
