#include "limn/refinement/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <ceres/ceres.h>

#include "limn/refinement/curve_terms.h"
#include "limn/refinement/selected_inverse.h"
#include "limn/refinement/stop_if_cancelled.h"
#include "limn/support/edgel_residual.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

using Triple = std::array<int, 3>;

constexpr int kMaxIterations = 8;

// The pulls at one sample: all its residuals, which depend on the two ends of its segment.
class PullCost : public ceres::CostFunction {
 public:
  PullCost(const CurveFitInput& input, const LinkSample& sample, double robust_px)
      : t_(sample.t), robust_px_(robust_px) {
    for (const EdgelPull& pull : sample.pulls) {
      const Edgel& edgel = input.curves[pull.ref.view].edge_map.edgels[pull.ref.edgel];
      pulls_.push_back(
          {&input.views[pull.ref.view], edgel, std::sqrt(pull.weight / ResidualVariance(edgel))});
    }
    set_num_residuals(static_cast<int>(sample.pulls.size()));
    *mutable_parameter_block_sizes() = {3, 3};
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> from(parameters[0]);
    const Eigen::Map<const Eigen::Vector3d> to(parameters[1]);
    const Eigen::Vector3d point = (1 - t_) * from + t_ * to;
    for (size_t i = 0; i < pulls_.size(); ++i) {
      const Pull pull = At(pulls_[i], point);
      residuals[i] = pull.residual;
      if (!jacobians) continue;
      for (const int end : {0, 1}) {
        if (!jacobians[end]) continue;
        Eigen::Map<Eigen::Vector3d> row(jacobians[end] + 3 * i);
        row = (end == 0 ? 1 - t_ : t_) * pull.gradient;
      }
    }
    return true;
  }

 private:
  struct WeightedLine {
    const View* view;
    EdgelLine line;
    double scale;  // square root of the weight
  };
  struct Pull {
    double residual = 0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  };

  // The square of this residual is the Cauchy loss of the distance.
  Pull At(const WeightedLine& pull, const Eigen::Vector3d& point) const {
    const auto distance = ResidualToEdgel(*pull.view, pull.line, point);
    if (!distance) return {};
    const double scale = pull.scale;
    const double relative = distance->residual_px / robust_px_;
    if (std::abs(relative) < 1e-4) {
      return {scale * distance->residual_px, scale * distance->gradient};
    }
    const double root = std::sqrt(std::log1p(relative * relative));
    const double slope = std::abs(relative) / ((1 + relative * relative) * root);
    return {scale * std::copysign(robust_px_ * root, relative), scale * slope * distance->gradient};
  }

  std::vector<WeightedLine> pulls_;
  double t_;
  double robust_px_;
};

// Links that hang together by nodes or bends, with the unknowns and bends among them: they share
// no unknown with others, which are fitted at the same time.
struct Component {
  std::vector<int> links;
  std::vector<int> points;  // ascending
  std::vector<Triple> bends;
};

class ComponentFit {
 public:
  ComponentFit(const CurveFitInput& input, const RefinementOptions& options,
               const Component& component, ControlGraph* control)
      : input_(input), options_(options), component_(component), control_(control) {
    for (const int point : component.points) {
      problem_.AddParameterBlock(Position(point), 3);
      AddHold(point, control, &problem_);
    }
    for (const int link : component.links) AddPulls(link);
    for (const Triple& bend : component.bends) AddBend(bend, options, control, &problem_);
  }

  void Solve(const RunContext& context) {
    StopIfCancelled stop(context);
    ceres::Solver::Options solver;
    solver.callbacks = {&stop};
    solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // Without BLAS: the same bits whatever runs beside it.
    solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    solver.max_num_iterations = kMaxIterations;
    solver.function_tolerance = 1e-5;
    // These two know units of length.
    solver.parameter_tolerance = 0;
    solver.gradient_tolerance = 0;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    ThrowIfCancelled(context);
  }

  // Into the places of the component's points. None if the normal matrix is singular, which the
  // holds prevent but for numbers beyond all scale.
  void FindCovariances(Covariances* covariances) {
    ceres::Problem::EvaluateOptions evaluation;
    for (const int point : component_.points)
      evaluation.parameter_blocks.push_back(Position(point));
    ceres::CRSMatrix rows;
    problem_.Evaluate(evaluation, nullptr, nullptr, nullptr, &rows);
    const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> jacobian(
        rows.num_rows, rows.num_cols, static_cast<Eigen::Index>(rows.values.size()),
        rows.rows.data(), rows.cols.data(), rows.values.data());
    const Eigen::SparseMatrix<double> by_column = jacobian;
    const Eigen::SparseMatrix<double> normal = by_column.transpose() * by_column;
    const auto blocks = DiagonalBlocksOfInverse(normal);
    if (!blocks) return;
    for (size_t i = 0; i < component_.points.size(); ++i) {
      (*covariances)[component_.points[i]] = (*blocks)[i];
    }
  }

 private:
  double* Position(int point) { return control_->position[point].data(); }

  void AddPulls(int link) {
    const std::vector<int>& points = control_->links[link].points;
    for (const LinkSample& sample : input_.matches[link]) {
      if (sample.pulls.empty()) continue;
      problem_.AddResidualBlock(new PullCost(input_, sample, options_.robust_residual_px), nullptr,
                                Position(points[sample.segment]),
                                Position(points[sample.segment + 1]));
    }
  }

  const CurveFitInput& input_;
  const RefinementOptions& options_;
  const Component& component_;
  ControlGraph* control_;
  ceres::Problem problem_;
};

std::vector<Component> FindComponents(const CurveFitInput& input, const ControlGraph& control) {
  UnionFind sets(static_cast<int>(control.position.size()));
  std::vector<uint8_t> unknown(control.position.size(), 0);
  for (size_t l = 0; l < control.links.size(); ++l) {
    if (input.frozen[l]) continue;
    for (const int point : control.links[l].points) {
      sets.Union(control.links[l].points.front(), point);
      unknown[point] = 1;
    }
  }
  // Bends hold together what a frozen link is between.
  std::vector<Triple> bends;
  for (const Triple& bend : control.bends) {
    const bool fitted = unknown[bend[0]] && unknown[bend[1]] && unknown[bend[2]];
    if (!fitted) continue;
    bends.push_back(bend);
    sets.Union(bend[0], bend[1]);
    sets.Union(bend[1], bend[2]);
  }
  std::map<int, Component> by_root;
  for (size_t l = 0; l < control.links.size(); ++l) {
    if (input.frozen[l]) continue;
    by_root[sets.Find(control.links[l].points.front())].links.push_back(static_cast<int>(l));
  }
  for (size_t p = 0; p < unknown.size(); ++p) {
    const int point = static_cast<int>(p);
    if (unknown[p]) by_root[sets.Find(point)].points.push_back(point);
  }
  for (const Triple& bend : bends) by_root[sets.Find(bend[1])].bends.push_back(bend);
  std::vector<Component> components;
  for (auto& [root, component] : by_root) components.push_back(std::move(component));
  return components;
}

}  // namespace

void FitCurves(const CurveFitInput& input, const RefinementOptions& options,
               const RunContext& context, ControlGraph* control, Covariances* covariances) {
  const std::vector<Eigen::Vector3d> before = control->position;
  const std::vector<Component> components = FindComponents(input, *control);
  if (covariances) covariances->assign(before.size(), std::nullopt);
  ParallelFor(context, "fitting curves", components.size(), [&](size_t c) {
    ComponentFit fit(input, options, components[c], control);
    fit.Solve(context);
    if (covariances) fit.FindCovariances(covariances);
  });
  FollowNodes(input.frozen, before, control);
  UpdateTangents(control);
}

}  // namespace limn
