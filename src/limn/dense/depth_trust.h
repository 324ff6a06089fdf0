#pragma once

#include <vector>

#include "limn/dense/depth_cause.h"
#include "limn/dense/depth_exam.h"
#include "limn/dense/sample_sights.h"

namespace limn {

// Whether dense results are those of the drawing.
struct DepthTrust {
  // Without, or if none of the depths is near the drawing, nothing is judged by them.
  bool is_believed = true;
  bool has_few_depths = false;  // hardly any is known where the views see the drawing
  DepthAgreement agreement;     // of all views
  size_t num_views = 0;         // with depths
  // Views whose depths are not used, since they do not fit, and why most do not.
  std::vector<ViewId> unfit;
  DepthCause cause;
};

// Watches over the depths of a drawing while they are used (algorithm/dense.md#trust).
class DepthJudge {
 public:
  // The arguments must outlive the judge and its depths. If depths are separate, those of a view
  // may be wrong alone.
  DepthJudge(const SurelySeen& seen, const std::vector<View>& views, const DepthSource& depths,
             bool are_separate, const DenseOptions& options);

  // The depths of the views that they fit. Refers to this.
  DepthSource FittingDepths();
  // After the depths of all views were requested.
  DepthTrust Conclude() const;

 private:
  struct OfView {
    ViewId view = -1;
    DepthAgreement agreement;
  };

  bool FitsAlone(const DepthAgreement& agreement) const;

  const SurelySeen& seen_;
  const std::vector<View>& views_;
  const DepthSource& depths_;
  bool are_separate_;
  const DenseOptions& options_;
  std::vector<OfView> looked_at_;
};

}  // namespace limn
