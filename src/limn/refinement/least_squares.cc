#include "limn/refinement/least_squares.h"

#include <atomic>

#include <ceres/ceres.h>

namespace limn {
namespace {

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

}  // namespace

bool Minimize(int max_iterations, const RunContext& context, ceres::Problem* problem) {
  StopIfCancelled stop(context);
  ceres::Solver::Options options;
  options.callbacks = {&stop};
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  // Without BLAS and threads, so that results are reproducible to the bit.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = 1e-5;
  // Disabled, because these two depend on the unit of length.
  options.parameter_tolerance = 0;
  options.gradient_tolerance = 0;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, problem, &summary);
  ThrowIfCancelled(context);
  return summary.IsSolutionUsable();
}

}  // namespace limn
