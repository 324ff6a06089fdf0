// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
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

// How the depths of a view agree with the drawing.
struct ViewDepthAgreement {
  ViewId view = -1;
  DepthAgreement agreement;
};

// How depths agree with the places of one view, beyond chance: its own, if it has any, and the best
// of others.
struct OwnAndOther {
  ViewId view = -1;
  std::vector<SeenPlace> places;
  std::optional<double> own = std::nullopt;
  double best_other = 0;
  ViewId best_of = -1;
};

// Watches over the depths of a drawing while they are used (algorithm/dense.md#trust).
class DepthWatch {
 public:
  // The arguments must outlive the watch and its depths. If depths are separate, those of a view
  // may be wrong alone, or be those of another.
  DepthWatch(const SurelySeen& seen, const std::vector<View>& views, bool are_separate,
             const DenseOptions& options);

  // The same depths, of which those that are asked for are compared with the drawing.
  DepthSource Watched(const DepthSource& depths);
  // After the depths of all views were asked for once.
  DepthTrust Judge() const;

 private:
  void Compare(ViewId view, const DepthImage& image);
  std::vector<ViewId> UnfitViews() const;

  const SurelySeen& seen_;
  const std::vector<View>& views_;
  bool are_separate_;
  DenseOptions options_;
  std::vector<ViewDepthAgreement> agreements_;
  std::vector<OwnAndOther> tests_;
};

// The depths of all but these views, which are sorted. Refers to the arguments.
DepthSource Without(const std::vector<ViewId>& views, const DepthSource& depths);

// Finds the cause of doubts about separate depths (FindDepthCause), if it is not known.
void ExplainDoubts(const SurelySeen& seen, const std::vector<View>& views,
                   const DepthSource& depths, const DenseOptions& options, DepthTrust* trust);

}  // namespace limn
