// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_calibration.h"

#include <utility>

#include <unsupported/Eigen/AutoDiff>

#include "colmap_ext/model/camera_lens_map.h"
#include "colmap_ext/model/distortion.h"

namespace limn::colmap_ext {
namespace {

constexpr int kMaxExtra = 12;
using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxExtra, 1>;
using Dual = Eigen::AutoDiffScalar<Derivatives>;

// A ray after distortion, with derivatives by the extra parameters.
distortion::Point<Dual> DistortByExtra(const Intrinsics& intrinsics, const Eigen::Vector2d& ray) {
  const int size = static_cast<int>(intrinsics.extra.size());
  const Derivatives none = Derivatives::Zero(size);
  std::vector<Dual> extra;
  for (int i = 0; i < size; ++i) extra.emplace_back(intrinsics.extra[i], size, i);
  return distortion::Distort<Dual, Dual>(intrinsics.model, extra.data(),
                                         {Dual(ray.x(), none), Dual(ray.y(), none)});
}

// Parameters are those of the camera, in the pixels of its own size.
class CameraCalibration : public Calibration {
 public:
  CameraCalibration(Camera camera, int width, int height)
      : camera_(std::move(camera)),
        intrinsics_(IntrinsicsOf(camera_)),
        width_(width),
        height_(height),
        scale_(width / static_cast<double>(camera_.width),
               height / static_cast<double>(camera_.height)) {}

  Eigen::VectorXd Parameters() const override {
    return Eigen::Map<const Eigen::VectorXd>(camera_.params.data(),
                                             static_cast<Eigen::Index>(camera_.params.size()));
  }

  std::optional<Eigen::Matrix2Xd> StoredByParameters(
      const Eigen::Vector2d& virtual_px) const override {
    const Eigen::Vector2d px = (virtual_px.array() + 0.5) / scale_.array();
    const Eigen::Vector2d ray((px.x() - intrinsics_.cx) / intrinsics_.fx,
                              (px.y() - intrinsics_.cy) / intrinsics_.fy);
    const auto q = DistortByExtra(intrinsics_, ray);
    const int num_focals = FindCameraModel(static_cast<int32_t>(camera_.model))->num_focals;
    const int num_extra = static_cast<int>(intrinsics_.extra.size());
    Eigen::Matrix2Xd columns = Eigen::Matrix2Xd::Zero(2, num_focals + 2 + num_extra);
    columns(0, 0) = q.u.value();
    columns(1, num_focals - 1) = q.v.value();
    columns(0, num_focals) = 1;
    columns(1, num_focals + 1) = 1;
    if (num_extra > 0) {
      columns.row(0).tail(num_extra) = intrinsics_.fx * q.u.derivatives().transpose();
      columns.row(1).tail(num_extra) = intrinsics_.fy * q.v.derivatives().transpose();
    }
    columns = scale_.asDiagonal() * columns;
    if (!columns.allFinite()) return std::nullopt;
    return columns;
  }

  Optics WithParameters(const Eigen::VectorXd& parameters) const override {
    Camera camera = camera_;
    camera.params.assign(parameters.begin(), parameters.end());
    return MakeOptics(camera, width_, height_);
  }

 private:
  Camera camera_;
  Intrinsics intrinsics_;
  int width_;
  int height_;
  Eigen::Vector2d scale_;
};

}  // namespace

Optics MakeOptics(const Camera& camera, int width, int height) {
  const Intrinsics intrinsics =
      Rescaled(IntrinsicsOf(camera), width / static_cast<double>(camera.width),
               height / static_cast<double>(camera.height));
  Optics optics;
  optics.camera = VirtualPinhole(intrinsics, width, height);
  if (!IsPinhole(intrinsics)) optics.lens = std::make_shared<CameraLensMap>(intrinsics);
  optics.calibration = std::make_shared<CameraCalibration>(camera, width, height);
  return optics;
}

}  // namespace limn::colmap_ext
