#include "limn/refinement/curve_fit.h"

#include <ceres/ceres.h>

#include "limn/refinement/least_squares.h"
#include "limn/refinement/selected_inverse.h"

namespace limn {
namespace {

constexpr int kMaxIterations = 8;

// Into the places of the component's points. None if the normal matrix is singular, which the holds
// prevent but for numbers beyond all scale.
void FindCovariances(const Component& component, ControlGraph* control, ceres::Problem* problem,
                     Covariances* covariances) {
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
  const Eigen::SparseMatrix<double> normal = by_column.transpose() * by_column;
  const auto blocks = DiagonalBlocksOfInverse(normal);
  if (!blocks) return;
  for (size_t i = 0; i < component.points.size(); ++i) {
    (*covariances)[component.points[i]] = (*blocks)[i];
  }
}

}  // namespace

void FitCurves(const FitInput& input, const RefinementOptions& options, const RunContext& context,
               ControlGraph* control, Covariances* covariances) {
  UpdateTangents(control);
  const std::vector<Eigen::Vector3d> before = control->position;
  const std::vector<Component> components = FindComponents(input.frozen, *control);
  if (covariances) covariances->assign(before.size(), std::nullopt);
  ParallelFor(context, "fitting curves", components.size(), [&](size_t c) {
    ceres::Problem problem;
    AddTerms(input, options, components[c], nullptr, control, &problem);
    Minimize(kMaxIterations, context, &problem);
    if (covariances) FindCovariances(components[c], control, &problem, covariances);
  });
  FollowNodes(input.frozen, before, control);
}

}  // namespace limn
