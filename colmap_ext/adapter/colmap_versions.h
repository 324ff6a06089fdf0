#pragma once

// COLMAP's library, and all that differs between its versions 3.8 to 4.1. What a version has is
// asked of its classes: no version number is compared.

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

// The pose as COLMAP has it: 3.8 has vectors, 4.0 functions instead of fields, and 3.12 composes it
// from rig and frame.
template <class Image>
Rigid3d ColmapPose(const Image& image) {
  if constexpr (requires { image.Qvec(); }) {
    const Eigen::Vector4d& q = image.Qvec();
    return {Eigen::Quaterniond(q[0], q[1], q[2], q[3]), image.Tvec()};
  } else {
    const auto& pose = image.CamFromWorld();
    if constexpr (requires { pose.rotation(); }) {
      return {Eigen::Quaterniond(pose.rotation()), Eigen::Vector3d(pose.translation())};
    } else {
      return {pose.rotation, pose.translation};
    }
  }
}

// Whether COLMAP normalizes rotations when it reads them: up to 3.10, before poses were optional.
template <class Image>
constexpr bool ReadsUnitRotations(const Image& image) {
  return !requires { image.HasPose(); };
}

// Several cameras of one rig: from 3.12 on.
template <class Reconstruction>
bool HasColmapRigs(const Reconstruction& reconstruction) {
  if constexpr (requires { reconstruction.Rigs(); }) {
    for (const auto& rig : reconstruction.Rigs()) {
      if (rig.second.NumSensors() > 1) return true;
    }
  }
  return false;
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
