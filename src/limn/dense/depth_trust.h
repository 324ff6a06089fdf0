#pragma once

#include <vector>

#include "limn/dense/depth_cause.h"
#include "limn/dense/depth_exam.h"
#include "limn/dense/sample_sights.h"

namespace limn {

// Whether dense results are those of the drawing.
struct DepthTrust {
  // False: nothing is judged by them.
  bool is_believed = true;
  bool has_few_depths = false;  // hardly any is known where the views see the drawing
  DepthAgreement agreement;     // of all views
  size_t num_views = 0;         // with depths
  // Views whose depths are not used, ascending: those that do not fit, if others do; else all.
  std::vector<ViewId> unfit;
  DepthCause cause;  // why they do not
};

struct ViewAgreement {
  ViewId view = -1;
  DepthAgreement agreement;
};

// The same depths; those of every view that is asked for are compared with the drawing. Refers to
// the arguments.
DepthSource Watched(const DepthSource& depths, const SurelySeen& seen,
                    const std::vector<View>& views, const DenseOptions& options,
                    std::vector<ViewAgreement>* agreements);

// The depths of all but these views, which are sorted. Refers to the arguments.
DepthSource Without(const std::vector<ViewId>& views, const DepthSource& depths);

// Judges the depths of all views that have any (algorithm/dense.md#trust). If they are separate,
// those of some may be wrong: they agree far less than the others.
DepthTrust JudgeDepths(const std::vector<ViewAgreement>& agreements, bool are_separate);

// Finds the cause, if there are doubts (FindDepthCause).
void ExplainDoubts(const SurelySeen& seen, const std::vector<View>& views,
                   const DepthSource& depths, const DenseOptions& options, DepthTrust* trust);

}  // namespace limn
