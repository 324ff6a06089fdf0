// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn::colmap_ext {
namespace {

using Id = CameraModelId;

// Indexed by id.
constexpr std::array<CameraModel, 18> kModels = {{
    {Id::kSimplePinhole, "SIMPLE_PINHOLE", 3, 1},
    {Id::kPinhole, "PINHOLE", 4, 2},
    {Id::kSimpleRadial, "SIMPLE_RADIAL", 4, 1},
    {Id::kRadial, "RADIAL", 5, 1},
    {Id::kOpencv, "OPENCV", 8, 2},
    {Id::kOpencvFisheye, "OPENCV_FISHEYE", 8, 2},
    {Id::kFullOpencv, "FULL_OPENCV", 12, 2},
    {Id::kFov, "FOV", 5, 2},
    {Id::kSimpleRadialFisheye, "SIMPLE_RADIAL_FISHEYE", 4, 1},
    {Id::kRadialFisheye, "RADIAL_FISHEYE", 5, 1},
    {Id::kThinPrismFisheye, "THIN_PRISM_FISHEYE", 12, 2},
    {Id::kRadTanThinPrismFisheye, "RAD_TAN_THIN_PRISM_FISHEYE", 16, 2},
    {Id::kSimpleDivision, "SIMPLE_DIVISION", 4, 1},
    {Id::kDivision, "DIVISION", 5, 2},
    {Id::kSimpleFisheye, "SIMPLE_FISHEYE", 3, 1},
    {Id::kFisheye, "FISHEYE", 4, 2},
    {Id::kEucm, "EUCM", 6, 2},
    {Id::kEquirectangular, "EQUIRECTANGULAR", 2, 0},
}};

// COLMAP's own bound for a camera that counts as undistorted.
constexpr double kNegligibleParam = 1e-8;

bool AllNegligible(const double* begin, const double* end) {
  return std::all_of(begin, end, [](double p) { return std::abs(p) <= kNegligibleParam; });
}

}  // namespace

const CameraModel* FindCameraModel(int32_t id) {
  if (id < 0 || id >= static_cast<int32_t>(kModels.size())) return nullptr;
  return &kModels[id];
}

const CameraModel* FindCameraModel(std::string_view name) {
  const auto found = std::find_if(kModels.begin(), kModels.end(),
                                  [&](const CameraModel& model) { return name == model.name; });
  return found == kModels.end() ? nullptr : &*found;
}

std::string SupportedCameraModels() {
  std::string names;
  for (const CameraModel& model : kModels) {
    if (!names.empty()) names += ", ";
    names += model.name;
  }
  return names;
}

Intrinsics IntrinsicsOf(const Camera& camera) {
  const int num_focals = kModels[static_cast<int>(camera.model)].num_focals;
  const double* params = camera.params.data();
  Intrinsics result;
  result.model = camera.model;
  result.fx = params[0];
  result.fy = params[num_focals - 1];
  result.cx = params[num_focals];
  result.cy = params[num_focals + 1];
  result.extra.assign(camera.params.begin() + num_focals + 2, camera.params.end());
  return result;
}

Intrinsics Rescaled(Intrinsics intrinsics, double scale_x, double scale_y) {
  intrinsics.fx *= scale_x;
  intrinsics.cx *= scale_x;
  intrinsics.fy *= scale_y;
  intrinsics.cy *= scale_y;
  return intrinsics;
}

bool IsPinhole(const Intrinsics& intrinsics) {
  const double* extra = intrinsics.extra.data();
  switch (intrinsics.model) {
    case Id::kSimplePinhole:
    case Id::kPinhole:
      return true;
    case Id::kSimpleRadial:
    case Id::kRadial:
    case Id::kOpencv:
    case Id::kFullOpencv:
    case Id::kFov:
    case Id::kSimpleDivision:
    case Id::kDivision:
      return AllNegligible(extra, extra + intrinsics.extra.size());
    case Id::kEucm:
      return AllNegligible(extra, extra + 1);  // alpha = 0 makes beta meaningless
    default:
      return false;
  }
}

}  // namespace limn::colmap_ext
