#include "limn/refinement/pull_cost.h"

#include <cmath>

#include "limn/refinement/camera_corrections.h"

namespace limn {
namespace {

// Distance of a point behind a camera, stored px: large, so that moving there never lowers the
// cost.
constexpr double kBehindPx = 1e3;

// The signed root of the Cauchy loss, and its derivative.
struct Root {
  double value;
  double slope;
};

Root RootOfLoss(double distance_px, double robust_px) {
  const double relative = distance_px / robust_px;
  if (std::abs(relative) < 1e-4) return {distance_px, 1};
  const double root = std::sqrt(std::log1p(relative * relative));
  return {std::copysign(robust_px * root, relative),
          std::abs(relative) / ((1 + relative * relative) * root)};
}

// J' v of the header.
Eigen::Vector3d TurnedBack(const Eigen::Vector3d& turn, const Eigen::Vector3d& v) {
  const double angle = turn.norm();
  // For small angles the first term of either series is exact enough.
  const bool is_small = angle < 1e-4;
  const double first = is_small ? 0.5 : (1 - std::cos(angle)) / (angle * angle);
  const double second = is_small ? 1.0 / 6 : (angle - std::sin(angle)) / (angle * angle * angle);
  return v - first * turn.cross(v) + second * turn.cross(turn.cross(v));
}

}  // namespace

PullCost::PullCost(std::vector<LinePull> pulls, std::vector<double> weights, double robust_px,
                   bool cameras_move)
    : pulls_(std::move(pulls)),
      weights_(std::move(weights)),
      robust_px_(robust_px),
      cameras_move_(cameras_move) {
  set_num_residuals(static_cast<int>(pulls_.size()));
  std::vector<int32_t>& sizes = *mutable_parameter_block_sizes();
  sizes.assign(weights_.size(), 3);
  if (cameras_move_) sizes.insert(sizes.end(), {6, 1});
}

bool PullCost::Evaluate(double const* const* parameters, double* residuals,
                        double** jacobians) const {
  const size_t num_points = weights_.size();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (size_t k = 0; k < num_points; ++k) {
    place += weights_[k] * Eigen::Map<const Eigen::Vector3d>(parameters[k]);
  }
  const double* motion = cameras_move_ ? parameters[num_points] : nullptr;
  for (size_t i = 0; i < pulls_.size(); ++i) {
    const auto& [view, line, scale] = pulls_[i];
    const auto [camera, pose] = motion ? Corrected(*view, motion, *parameters[num_points + 1])
                                       : PosedCamera{view->camera, view->cam_from_world};
    const auto distance = ResidualToEdgel(camera, pose, line, place);
    const EdgelResidual known = distance.value_or(EdgelResidual{kBehindPx});
    const Root root = RootOfLoss(known.residual_px, robust_px_);
    residuals[i] = scale * root.value;
    if (!jacobians) continue;
    const Eigen::Vector3d gradient = scale * root.slope * known.gradient;
    for (size_t k = 0; k < num_points; ++k) {
      if (jacobians[k]) Eigen::Map<Eigen::Vector3d>(jacobians[k] + 3 * i) = weights_[k] * gradient;
    }
    if (motion && jacobians[num_points]) {
      const Eigen::Vector3d in_camera = pose.rotation * gradient;
      const Eigen::Vector3d turned = pose * place - Eigen::Map<const Eigen::Vector3d>(motion + 3);
      Eigen::Map<Eigen::Matrix<double, 6, 1>> row(jacobians[num_points] + 6 * i);
      row << TurnedBack(Eigen::Map<const Eigen::Vector3d>(motion), turned.cross(in_camera)),
          in_camera;
    }
    if (motion && jacobians[num_points + 1]) {
      const Eigen::Vector2d from_center = line.position_px - Eigen::Vector2d(camera.cx, camera.cy);
      jacobians[num_points + 1][i] =
          distance ? scale * root.slope * (known.residual_px + line.across.dot(from_center)) : 0;
    }
  }
  return true;
}

}  // namespace limn
