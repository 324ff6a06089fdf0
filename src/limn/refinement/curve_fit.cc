// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/curve_fit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <utility>

#include <ceres/ceres.h>

#include "limn/refinement/pull_cost.h"
#include "limn/refinement/selected_inverse.h"
#include "limn/util/quiet_solver.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr int kMaxIterations = 8;
// Standard deviations of the distance of a point from its place in the drawing, px: along its
// curve, in any direction, and at a corner. They decide only what edgels and bending leave open.
constexpr double kAlongSigmaPx = 1;
constexpr double kWeakSigmaPx = 30;
constexpr double kCornerSigmaPx = 3;
// Next to a corner, changes of direction beyond this many of their standard deviations hardly count
// (Cauchy), so that links that do not quite meet do not drag each other away.
constexpr double kCornerBendSigmas = 3;

// A sum of points, each with a coefficient matrix, less a constant.
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(std::vector<Eigen::Matrix3d> factors, const Eigen::Vector3d& target)
      : factors_(std::move(factors)), target_(target) {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(factors_.size(), 3);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    Eigen::Vector3d sum = -target_;
    for (size_t i = 0; i < factors_.size(); ++i) {
      sum += factors_[i] * Eigen::Map<const Eigen::Vector3d>(parameters[i]);
      if (jacobians && jacobians[i]) Eigen::Map<RowMajor3d>{jacobians[i]} = factors_[i];
    }
    Eigen::Map<Eigen::Vector3d>{residuals} = sum;
    return true;
  }

 private:
  std::vector<Eigen::Matrix3d> factors_;
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

Eigen::Vector3d WeightedSum(const std::array<double, 3>& factors, const Bend& bend,
                            const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += factors[i] * points[bend[i]];
  return sum;
}

const std::optional<double>* HeldAt(int point, const ControlGraph& control) {
  return control.held.empty() || !control.held[point] ? nullptr : &control.held[point];
}

// Hold a point weakly where it was in the drawing: along its curve, and at a corner. One that must
// stay is as uncertain as it was.
void AddHold(int point, ControlGraph* control, ceres::Problem* problem) {
  if (const std::optional<double>* sigma = HeldAt(point, *control)) {
    const Eigen::Matrix3d factor = Eigen::Matrix3d::Identity() / **sigma;
    problem->AddResidualBlock(new LinearCost({factor}, factor * control->start[point]), nullptr,
                              control->position[point].data());
    return;
  }
  const double across_px = control->corner[point] ? kCornerSigmaPx : kWeakSigmaPx;
  const double along_px = control->corner[point] ? kCornerSigmaPx : kAlongSigmaPx;
  const Eigen::Vector3d& tangent = control->tangent[point];
  const Eigen::Matrix3d factor = (Eigen::Matrix3d::Identity() / across_px +
                                  (1 / along_px - 1 / across_px) * tangent * tangent.transpose()) /
                                 control->footprint[point];
  problem->AddResidualBlock(new LinearCost({factor}, factor * control->start[point]), nullptr,
                            control->position[point].data());
}

// The penalty on the change of direction at the middle one of three neighbors.
void AddBend(const Bend& bend, const RefinementOptions& options, ControlGraph* control,
             ceres::Problem* problem) {
  std::vector<Eigen::Vector3d>& position = control->position;
  const std::array<double, 3> factor = BendFactors(bend, options, *control);
  std::vector<Eigen::Matrix3d> matrices;
  for (const double of_point : factor) matrices.push_back(of_point * Eigen::Matrix3d::Identity());
  const bool at_corner = control->corner[bend[0]] || control->corner[bend[2]];
  const Eigen::Vector3d target =
      control->keeps_shape ? WeightedSum(factor, bend, control->start) : Eigen::Vector3d::Zero();
  problem->AddResidualBlock(new LinearCost(std::move(matrices), target),
                            at_corner ? new ceres::CauchyLoss(kCornerBendSigmas) : nullptr,
                            position[bend[0]].data(), position[bend[1]].data(),
                            position[bend[2]].data());
}

// All pulls of a sample share one block.
void AddPulls(const std::vector<View>& views, const FitSample& sample, const ControlLink& link,
              double robust_px, ControlGraph* control, ceres::Problem* problem) {
  if (sample.pulls.empty()) return;
  std::vector<LinePull> pulls;
  for (const EdgelPull& pull : sample.pulls) {
    pulls.push_back({&views[pull.ref.view], pull.line, std::sqrt(pull.weight)});
  }
  const std::vector<double> weights = {1 - sample.t, sample.t};
  problem->AddResidualBlock(new PullCost(std::move(pulls), weights, robust_px), nullptr,
                            control->position[link.points[sample.segment]].data(),
                            control->position[link.points[sample.segment + 1]].data());
}

// Stops a solver between iterations when the run is canceled.
class StopIfCancelled : public ceres::IterationCallback {
 public:
  explicit StopIfCancelled(const RunContext& context) : context_(context) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    const bool stop = context_.cancelled && context_.cancelled->load(std::memory_order_relaxed);
    return stop ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const RunContext& context_;
};

// Adds the terms of a component to a least squares problem whose unknowns are the positions in
// `control`.
void AddTerms(const std::vector<View>& views, const RefinementOptions& options,
              const Component& component, ControlGraph* control, ceres::Problem* problem) {
  for (const int point : component.points) AddHold(point, control, problem);
  for (const int id : component.links) {
    const ControlLink& link = control->links[id];
    for (const FitSample& sample : link.samples) {
      AddPulls(views, sample, link, options.robust_residual_px, control, problem);
    }
  }
  for (const Bend& bend : component.bends) AddBend(bend, options, control, problem);
}

// By sparse Cholesky factorization of the normal matrix, on one thread. Changes nothing if there is
// no usable solution.
void Minimize(const RunContext& context, ceres::Problem* problem) {
  StopIfCancelled stop(context);
  ceres::Solver::Options options;
  options.callbacks = {&stop};
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  // Without BLAS and threads, so that results are reproducible to the bit.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = kMaxIterations;
  options.function_tolerance = 1e-5;
  // Disabled, because these two depend on the unit of length.
  options.parameter_tolerance = 0;
  options.gradient_tolerance = 0;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, problem, &summary);
  ThrowIfCancelled(context);
}

// Sets the covariances of a component's points, unless the normal matrix is singular, which the
// holds prevent except with extreme numbers.
void SetCovariances(const Component& component, ControlGraph* control, ceres::Problem* problem) {
  ceres::Problem::EvaluateOptions evaluation;
  for (const int point : component.points) {
    evaluation.parameter_blocks.push_back(control->position[point].data());
  }
  ceres::CRSMatrix rows;
  problem->Evaluate(evaluation, nullptr, nullptr, nullptr, &rows);
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> jacobian(
      rows.num_rows, rows.num_cols, static_cast<Eigen::Index>(rows.values.size()), rows.rows.data(),
      rows.cols.data(), rows.values.data());
  const Eigen::SparseMatrix<double> by_column = jacobian;
  const auto blocks = DiagonalBlocksOfInverse(by_column.transpose() * by_column);
  if (!blocks) return;
  for (size_t i = 0; i < component.points.size(); ++i) {
    control->covariance[component.points[i]] = (*blocks)[i];
  }
}

}  // namespace

std::vector<Component> FindComponents(const ControlGraph& control) {
  const int num_points = static_cast<int>(control.position.size());
  UnionFind sets(num_points);
  std::vector<uint8_t> unknown(control.position.size(), 0);
  for (const ControlLink& link : control.links) {
    if (link.frozen) continue;
    for (const int point : link.points) {
      sets.Union(link.points.front(), point);
      unknown[point] = 1;
    }
  }
  std::vector<Bend> bends;
  for (const Bend& bend : control.bends) {
    if (!unknown[bend[0]] || !unknown[bend[1]] || !unknown[bend[2]]) continue;
    bends.push_back(bend);
    // A bend may include both nodes of a frozen link and so connect its neighbors.
    sets.Union(bend[0], bend[1]);
    sets.Union(bend[1], bend[2]);
  }
  std::map<int, Component> by_root;
  for (size_t l = 0; l < control.links.size(); ++l) {
    const ControlLink& link = control.links[l];
    if (!link.frozen) by_root[sets.Find(link.points[0])].links.push_back(static_cast<int>(l));
  }
  for (int p = 0; p < num_points; ++p) {
    if (unknown[p]) by_root[sets.Find(p)].points.push_back(p);
  }
  for (const Bend& bend : bends) by_root[sets.Find(bend[1])].bends.push_back(bend);
  std::vector<Component> components;
  for (auto& [root, component] : by_root) components.push_back(std::move(component));
  return components;
}

double SquaredBend(const Bend& bend, const RefinementOptions& options,
                   const ControlGraph& control) {
  const std::array<double, 3> factor = BendFactors(bend, options, control);
  Eigen::Vector3d sum = WeightedSum(factor, bend, control.position);
  if (control.keeps_shape) sum -= WeightedSum(factor, bend, control.start);
  return sum.squaredNorm();
}

void FitCurves(const std::vector<View>& views, const RefinementOptions& options,
               const RunContext& context, bool with_covariances, ControlGraph* control) {
  const QuietSolver quiet;
  UpdateTangents(control);
  const std::vector<Eigen::Vector3d> before = control->position;
  const std::vector<Component> components = FindComponents(*control);
  ParallelFor(context, "fitting curves", components.size(), [&](size_t c) {
    ceres::Problem problem;
    AddTerms(views, options, components[c], control, &problem);
    for (const int point : components[c].points) {
      double* position = control->position[point].data();
      if (HeldAt(point, *control)) problem.SetParameterBlockConstant(position);
    }
    Minimize(context, &problem);
    // Points that stay are not more certain for that.
    for (const int point : components[c].points) {
      problem.SetParameterBlockVariable(control->position[point].data());
    }
    if (with_covariances) SetCovariances(components[c], control, &problem);
  });
  FollowNodes(before, control);
}

}  // namespace limn
