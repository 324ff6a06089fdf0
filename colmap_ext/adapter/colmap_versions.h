// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// COLMAP's library, and everything that differs between versions 3.8 and 4.2. The code asks
// COLMAP's classes what they have instead of comparing version numbers.

#if __has_include(<colmap/scene/reconstruction.h>)
#include <colmap/scene/reconstruction.h>
#include <colmap/util/threading.h>
#else  // 3.8
#include <base/reconstruction.h>
#include <util/threading.h>
#endif
#if __has_include(<colmap/util/base_controller.h>)
#include <colmap/util/base_controller.h>
#define LIMN_COLMAP_HAS_BASE_CONTROLLER
#endif

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/model/model.h"
#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

// 3.8 hides fields behind functions.

template <class Camera>
auto ColmapModelId(const Camera& camera) {
  if constexpr (requires { camera.ModelId(); }) {
    return static_cast<int32_t>(camera.ModelId());
  } else {
    return static_cast<int32_t>(camera.model_id);
  }
}

template <class Camera>
std::pair<uint64_t, uint64_t> ColmapSize(const Camera& camera) {
  if constexpr (requires { camera.Width(); }) {
    return {camera.Width(), camera.Height()};
  } else {
    return {camera.width, camera.height};
  }
}

template <class Camera>
const std::vector<double>& ColmapParams(const Camera& camera) {
  if constexpr (requires { camera.Params(); }) {
    return camera.Params();
  } else {
    return camera.params;
  }
}

template <class Point2D>
const Eigen::Vector2d& ColmapPixel(const Point2D& point) {
  if constexpr (requires { point.XY(); }) {
    return point.XY();
  } else {
    return point.xy;
  }
}

template <class Point2D>
uint64_t ColmapPointId(const Point2D& point) {
  if constexpr (requires { point.Point3DId(); }) {
    return point.Point3DId();
  } else {
    return point.point3D_id;
  }
}

// Position, color, error and track of a 3D point, given to `visit`.
template <class Point3D, class Visit>
void VisitColmapPoint(const Point3D& point, const Visit& visit) {
  if constexpr (requires { point.XYZ(); }) {
    visit(point.XYZ(), point.Color(), point.Error(), point.Track());
  } else {
    visit(point.xyz, point.color, point.error, point.track);
  }
}

template <class Point3D>
void SetColmapError(double error, Point3D* point) {
  if constexpr (requires { point->SetError(error); }) {
    point->SetError(error);
  } else {
    point->error = error;
  }
}

// 4.0 has functions instead of fields.
template <class Pose>
Rigid3d ToRigid(const Pose& pose) {
  if constexpr (requires { pose.rotation(); }) {
    return {Eigen::Quaterniond(pose.rotation()), Eigen::Vector3d(pose.translation())};
  } else {
    return {pose.rotation, pose.translation};
  }
}

// The pose as COLMAP has it: 3.8 has vectors, and 3.12 composes it from rig and frame.
template <class Image>
Rigid3d ColmapPose(const Image& image) {
  if constexpr (requires { image.Qvec(); }) {
    const Eigen::Vector4d& q = image.Qvec();
    return {Eigen::Quaterniond(q[0], q[1], q[2], q[3]), image.Tvec()};
  } else {
    return ToRigid(image.CamFromWorld());
  }
}

// Whether COLMAP normalizes rotations when it reads them: up to 3.10, before poses were optional.
template <class Image>
constexpr bool ReadsUnitRotations(const Image& image) {
  return !requires { image.HasPose(); };
}

template <class Sensor>
SensorId ToSensorId(const Sensor& sensor) {
  return {static_cast<int32_t>(sensor.type), sensor.id};
}

template <class ColmapRig>
Rig ToRig(const ColmapRig& from) {
  Rig rig;
  rig.id = from.RigId();
  if (from.NumSensors() == 0) return rig;
  rig.sensors.push_back({ToSensorId(from.RefSensorId()), true, {}});
  for (const auto& [sensor, pose] : from.NonRefSensors()) {
    rig.sensors.push_back(
        {ToSensorId(sensor), pose.has_value(), pose ? ToRigid(*pose) : Rigid3d{}});
  }
  return rig;
}

template <class ColmapFrame>
Frame ToFrame(const ColmapFrame& from) {
  Frame frame = {from.FrameId(), from.RigId(), ToRigid(from.RigFromWorld()), {}};
  for (const auto& data : from.DataIds()) {
    frame.data.push_back({ToSensorId(data.sensor_id), data.id});
  }
  return frame;
}

// Rigs, and frames with a pose, by their ids: from 3.12 on.
template <class Reconstruction>
void AddColmapRigs(const Reconstruction& reconstruction, SparseModel* model) {
  if constexpr (requires { reconstruction.Rigs(); }) {
    for (const auto& [id, rig] : reconstruction.Rigs()) model->rigs.push_back(ToRig(rig));
    for (const auto& [id, frame] : reconstruction.Frames()) {
      if (frame.HasPose()) model->frames.push_back(ToFrame(frame));
    }
    const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
    std::sort(model->rigs.begin(), model->rigs.end(), by_id);
    std::sort(model->frames.begin(), model->frames.end(), by_id);
  }
}

// Appends 2D points without 3D points. 3.8 takes them only for an image without any.
template <class Image>
void AddColmapPixels(const std::vector<Eigen::Vector2d>& pixels, Image* image) {
  if constexpr (requires { image->Points2D().emplace_back(); }) {
    for (const Eigen::Vector2d& pixel : pixels) image->Points2D().emplace_back().xy = pixel;
  } else {
    Image longer;
    longer.SetImageId(image->ImageId());
    longer.SetName(image->Name());
    longer.SetCameraId(image->CameraId());
    longer.SetRegistered(image->IsRegistered());
    longer.SetQvec(image->Qvec());
    longer.SetTvec(image->Tvec());
    longer.SetQvecPrior(image->QvecPrior());
    longer.SetTvecPrior(image->TvecPrior());
    auto points = image->Points2D();
    for (auto& point : points) point.SetPoint3DId(kNoPoint3D);
    for (const Eigen::Vector2d& pixel : pixels) {
      points.emplace_back();
      points.back().SetXY(pixel);
    }
    longer.SetPoints2D(points);
    for (size_t i = 0; i < image->Points2D().size(); ++i) {
      const auto& point = image->Points2D()[i];
      if (point.HasPoint3D()) longer.SetPoint3DForPoint2D(i, point.Point3DId());
    }
    *image = std::move(longer);
  }
}

// A stage of a program: a thread of its own up to 3.9, to be run by any thread later.
#ifdef LIMN_COLMAP_HAS_BASE_CONTROLLER
using ColmapController = colmap::BaseController;
#else
using ColmapController = colmap::Thread;
#endif

// Waits while it is paused.
template <class Controller>
bool IsColmapStopped(Controller* controller) {
  if constexpr (requires { controller->CheckIfStopped(); }) {
    return controller->CheckIfStopped();
  } else {
    controller->BlockIfPaused();
    return controller->IsStopped();
  }
}

}  // namespace limn::colmap_ext
