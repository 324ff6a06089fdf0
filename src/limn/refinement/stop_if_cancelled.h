#pragma once

#include <atomic>

#include <ceres/iteration_callback.h>

#include "limn/util/parallel.h"

namespace limn {

// Ends a solver between two iterations when the run is to stop; whoever called it is to
// ThrowIfCancelled then.
class StopIfCancelled : public ceres::IterationCallback {
 public:
  // `context` must outlive this.
  explicit StopIfCancelled(const RunContext& context) : context_(context) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    const bool stop = context_.cancelled && context_.cancelled->load(std::memory_order_relaxed);
    return stop ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const RunContext& context_;
};

}  // namespace limn
