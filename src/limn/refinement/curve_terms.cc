#include "limn/refinement/curve_terms.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <ceres/ceres.h>

#include "limn/refinement/pull_cost.h"
#include "limn/support/edgel_residual.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Standard deviations of the distance of a point from its place in the drawing, px: along its
// curve, in any direction, and at a corner. They decide only what edgels and bending leave open.
constexpr double kAlongSigmaPx = 1;
constexpr double kWeakSigmaPx = 30;
constexpr double kCornerSigmaPx = 3;
// Next to a corner, changes of direction beyond this many of their standard deviations hardly count
// (Cauchy), so that links that do not quite meet do not drag each other away.
constexpr double kCornerBendSigmas = 3;

const Edgel& EdgelOf(const EdgelPull& pull, const std::vector<ImageCurves>& curves) {
  return curves[pull.ref.view].edge_map.edgels[pull.ref.edgel];
}

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
std::array<double, 3> BendFactors(const Bend& bend, const RefinementOptions& options,
                                  const ControlGraph& control) {
  const double footprint = control.footprint[bend[1]];
  const auto length = [&](int a, int b) {
    // The change of direction diverges where points nearly coincide.
    return std::max((control.position[b] - control.position[a]).norm(),
                    0.25 * options.control_spacing_px * footprint);
  };
  const double first = length(bend[0], bend[1]);
  const double second = length(bend[1], bend[2]);
  const double length_px = 0.5 * (first + second) / footprint;
  const double factor = 1 / (options.bending_sigma * std::sqrt(length_px));
  return {factor / first, factor * (-1 / first - 1 / second), factor / second};
}

// Hold a point weakly where it was in the drawing: along its curve, and at a corner.
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

// The penalty on the change of direction at the middle one of three neighbors.
void AddBend(const Bend& bend, const RefinementOptions& options, ControlGraph* control,
             ceres::Problem* problem) {
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

// All pulls of a sample share one block; if cameras move, each has its own, since their cameras
// differ.
void AddPulls(const FitInput& input, const LinkSample& sample, const ControlLink& link,
              double robust_px, CameraCorrections* cameras, ControlGraph* control,
              ceres::Problem* problem) {
  std::vector<LinePull> pulls;
  for (const EdgelPull& pull : sample.pulls) {
    pulls.push_back({&input.views[pull.ref.view], EdgelOf(pull, input.curves),
                     std::sqrt(WeightOf(pull, input.curves))});
  }
  const std::vector<double> weights = {1 - sample.t, sample.t};
  double* from = control->position[link.points[sample.segment]].data();
  double* to = control->position[link.points[sample.segment + 1]].data();
  if (!cameras) {
    if (pulls.empty()) return;
    problem->AddResidualBlock(new PullCost(std::move(pulls), weights, robust_px, false), nullptr,
                              from, to);
    return;
  }
  for (size_t i = 0; i < pulls.size(); ++i) {
    const ViewId view = sample.pulls[i].ref.view;
    problem->AddResidualBlock(new PullCost({pulls[i]}, weights, robust_px, true), nullptr, from, to,
                              cameras->motion[view].data(),
                              &cameras->log_focal.at(input.views[view].camera_index));
  }
}

}  // namespace

std::vector<Component> FindComponents(const std::vector<uint8_t>& frozen,
                                      const ControlGraph& control) {
  UnionFind sets(static_cast<int>(control.position.size()));
  std::vector<uint8_t> unknown(control.position.size(), 0);
  for (size_t l = 0; l < control.links.size(); ++l) {
    if (frozen[l]) continue;
    for (const int point : control.links[l].points) {
      sets.Union(control.links[l].points.front(), point);
      unknown[point] = 1;
    }
  }
  // A bend may include both nodes of a frozen link and so connect its neighbors.
  std::vector<Bend> bends = control.bends;
  std::erase_if(bends, [&](const Bend& bend) {
    return !unknown[bend[0]] || !unknown[bend[1]] || !unknown[bend[2]];
  });
  for (const Bend& bend : bends) {
    sets.Union(bend[0], bend[1]);
    sets.Union(bend[1], bend[2]);
  }
  std::map<int, Component> by_root;
  for (size_t l = 0; l < control.links.size(); ++l) {
    if (frozen[l]) continue;
    by_root[sets.Find(control.links[l].points.front())].links.push_back(static_cast<int>(l));
  }
  for (size_t p = 0; p < unknown.size(); ++p) {
    const int point = static_cast<int>(p);
    if (unknown[p]) by_root[sets.Find(point)].points.push_back(point);
  }
  for (const Bend& bend : bends) by_root[sets.Find(bend[1])].bends.push_back(bend);
  std::vector<Component> components;
  for (auto& [root, component] : by_root) components.push_back(std::move(component));
  return components;
}

void AddTerms(const FitInput& input, const RefinementOptions& options, const Component& component,
              CameraCorrections* cameras, ControlGraph* control, ceres::Problem* problem) {
  for (const int point : component.points) AddHold(point, control, problem);
  for (const int link : component.links) {
    for (const LinkSample& sample : input.matches[link]) {
      AddPulls(input, sample, control->links[link], options.robust_residual_px, cameras, control,
               problem);
    }
  }
  for (const auto& bend : component.bends) AddBend(bend, options, control, problem);
}

double WeightOf(const EdgelPull& pull, const std::vector<ImageCurves>& curves) {
  return pull.weight / ResidualVariance(EdgelOf(pull, curves));
}

double SquaredBend(const Bend& bend, const RefinementOptions& options,
                   const ControlGraph& control) {
  const std::array<double, 3> factor = BendFactors(bend, options, control);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += factor[i] * control.position[bend[i]];
  return sum.squaredNorm();
}

}  // namespace limn
