// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/brown_lens.h"

#include <algorithm>
#include <cmath>

#include "colmap_ext/import/measurement_distortion.h"

namespace limn::colmap_ext {
namespace {

constexpr double kMaxLensErrorPx = 0.01;

void Append(CameraModelId model, const std::vector<double>& extra, Camera* camera) {
  camera->model = model;
  camera->params.insert(camera->params.end(), extra.begin(), extra.end());
}

// Of the corner farthest from the principal point.
double RadiusOfImage(const Camera& camera) {
  const auto farthest = [](double center, uint64_t size) {
    return std::max(std::abs(center), std::abs(static_cast<double>(size) - center));
  };
  return std::hypot(farthest(camera.params[2], camera.width) / camera.params[0],
                    farthest(camera.params[3], camera.height) / camera.params[1]);
}

std::vector<double> FittedExtra(const BrownLens& lens, const FilePlace& place,
                                const Camera& camera) {
  const double focal = std::max(camera.params[0], camera.params[1]);
  if (!(std::min(camera.params[0], camera.params[1]) > 0)) {
    place.Fail("the focal length is not positive");
  }
  auto fitted = FitRadialPolynomial(lens.k, RadiusOfImage(camera));
  if (!fitted || !(fitted->max_error * focal <= kMaxLensErrorPx)) {
    place.Fail("the radial distortion with k4 = " + std::to_string(lens.k[3]) +
               " is none of COLMAP's cameras: export undistorted images, or without k4");
  }
  fitted->extra[2] = lens.p1;
  fitted->extra[3] = lens.p2;
  return fitted->extra;
}

}  // namespace

void SetBrownLens(const BrownLens& lens, const FilePlace& place, Camera* camera) {
  const auto& [k1, k2, k3, k4] = lens.k;
  if (k4 != 0) {
    Append(CameraModelId::kFullOpencv, FittedExtra(lens, place, *camera), camera);
  } else if (k3 != 0) {
    Append(CameraModelId::kFullOpencv, {k1, k2, lens.p1, lens.p2, k3, 0, 0, 0}, camera);
  } else if (k1 != 0 || k2 != 0 || lens.p1 != 0 || lens.p2 != 0) {
    Append(CameraModelId::kOpencv, {k1, k2, lens.p1, lens.p2}, camera);
  }
}

void SetFisheyeLens(const BrownLens& lens, Camera* camera) {
  const auto& [k1, k2, k3, k4] = lens.k;
  if (lens.p1 == 0 && lens.p2 == 0) {
    Append(CameraModelId::kOpencvFisheye, {k1, k2, k3, k4}, camera);
  } else {
    Append(CameraModelId::kThinPrismFisheye, {k1, k2, lens.p1, lens.p2, k3, k4, 0, 0}, camera);
  }
}

}  // namespace limn::colmap_ext
