// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "limn/model/calibration.h"

namespace limn::testing {

// A pinhole whose parameters are its focal length and its principal point.
class PinholeCalibration : public Calibration {
 public:
  explicit PinholeCalibration(const PinholeCamera& camera) : camera_(camera) {}
  Eigen::VectorXd Parameters() const override {
    return Eigen::Vector3d(camera_.fx, camera_.cx, camera_.cy);
  }
  std::optional<Eigen::Matrix2Xd> StoredByParameters(const Eigen::Vector2d& px) const override {
    Eigen::Matrix2Xd columns(2, 3);
    columns << (px.x() - camera_.cx) / camera_.fx, 1, 0, (px.y() - camera_.cy) / camera_.fy, 0, 1;
    return columns;
  }
  Optics WithParameters(const Eigen::VectorXd& parameters) const override {
    PinholeCamera camera = camera_;
    camera.fx = camera.fy = parameters[0];
    camera.cx = parameters[1];
    camera.cy = parameters[2];
    return {camera, nullptr, std::make_shared<PinholeCalibration>(camera)};
  }

 private:
  PinholeCamera camera_;
};

}  // namespace limn::testing
