#include "limn/refinement/curve_terms.h"

#include <algorithm>
#include <cmath>

#include <ceres/ceres.h>

namespace limn {
namespace {

using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Standard deviations of how far a point moves from where it was in the drawing: along its curve,
// in any direction, and at a corner. They decide nothing but what edgels and bending leave open.
// Px.
constexpr double kAlongSigmaPx = 1;
constexpr double kWeakSigmaPx = 30;
constexpr double kCornerSigmaPx = 3;
// Next to a corner, changes of direction beyond this many of their standard deviations hardly count
// (Cauchy): links that do not quite meet shall not drag each other away.
constexpr double kCornerBendSigmas = 3;

// A sum of points, each with a coefficient matrix, less a constant.
template <int kNumPoints>
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(const std::array<Eigen::Matrix3d, kNumPoints>& factors, const Eigen::Vector3d& target)
      : factors_(factors), target_(target) {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(kNumPoints, 3);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    Eigen::Vector3d sum = -target_;
    for (int i = 0; i < kNumPoints; ++i) {
      sum += factors_[i] * Eigen::Map<const Eigen::Vector3d>(parameters[i]);
      if (!jacobians || !jacobians[i]) continue;
      Eigen::Map<RowMajor3d> jacobian(jacobians[i]);
      jacobian = factors_[i];
    }
    Eigen::Map<Eigen::Vector3d> out(residuals);
    out = sum;
    return true;
  }

 private:
  std::array<Eigen::Matrix3d, kNumPoints> factors_;
  Eigen::Vector3d target_;
};

// Coefficients of three neighbors whose sum is the change of direction in standard deviations.
std::array<double, 3> BendFactors(const std::array<int, 3>& bend, const RefinementOptions& options,
                                  const ControlGraph& control) {
  const double footprint = control.footprint[bend[1]];
  const auto length = [&](int a, int b) {
    // Points that nearly coincide would make the change of direction explode.
    return std::max((control.position[b] - control.position[a]).norm(),
                    0.25 * options.control_spacing_px * footprint);
  };
  const double first = length(bend[0], bend[1]);
  const double second = length(bend[1], bend[2]);
  const double length_px = 0.5 * (first + second) / footprint;
  const double factor = 1 / (options.bending_sigma * std::sqrt(length_px));
  return {factor / first, factor * (-1 / first - 1 / second), factor / second};
}

}  // namespace

void AddHold(int point, ControlGraph* control, ceres::Problem* problem) {
  const double across_px = control->corner[point] ? kCornerSigmaPx : kWeakSigmaPx;
  const double along_px = control->corner[point] ? kCornerSigmaPx : kAlongSigmaPx;
  const Eigen::Vector3d& tangent = control->tangent[point];
  const Eigen::Matrix3d factor = (Eigen::Matrix3d::Identity() / across_px +
                                  (1 / along_px - 1 / across_px) * tangent * tangent.transpose()) /
                                 control->footprint[point];
  problem->AddResidualBlock(new LinearCost<1>({factor}, factor * control->start[point]), nullptr,
                            control->position[point].data());
}

void AddBend(const std::array<int, 3>& bend, const RefinementOptions& options,
             ControlGraph* control, ceres::Problem* problem) {
  std::vector<Eigen::Vector3d>& position = control->position;
  const std::array<double, 3> factor = BendFactors(bend, options, *control);
  const auto matrix = [&](int i) -> Eigen::Matrix3d {
    return factor[i] * Eigen::Matrix3d::Identity();
  };
  const bool at_corner = control->corner[bend[0]] || control->corner[bend[2]];
  problem->AddResidualBlock(
      new LinearCost<3>({matrix(0), matrix(1), matrix(2)}, Eigen::Vector3d::Zero()),
      at_corner ? new ceres::CauchyLoss(kCornerBendSigmas) : nullptr, position[bend[0]].data(),
      position[bend[1]].data(), position[bend[2]].data());
}

double SquaredBend(const std::array<int, 3>& bend, const RefinementOptions& options,
                   const ControlGraph& control) {
  const std::array<double, 3> factor = BendFactors(bend, options, control);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += factor[i] * control.position[bend[i]];
  return sum.squaredNorm();
}

}  // namespace limn
