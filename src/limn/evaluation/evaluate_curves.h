// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "limn/evaluation/camera_accuracy.h"
#include "limn/evaluation/evaluation_options.h"
#include "limn/evaluation/face_scores.h"
#include "limn/evaluation/feature_scores.h"
#include "limn/evaluation/hss.h"
#include "limn/evaluation/kind_confusion.h"
#include "limn/evaluation/normalized_errors.h"
#include "limn/evaluation/reliability.h"
#include "limn/evaluation/saw_teeth.h"
#include "limn/evaluation/structure_scores.h"
#include "limn/model/curve_set.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Shares are in [0, 1], and absent if the total is zero.
struct TauResult {
  double tau = 0;
  // Share of the reconstructed length (or points) within tau of the truth.
  std::optional<double> precision;
  // The paper's precision read literally, in samples: the true ones within tau of the
  // reconstruction over these and the reconstructed ones that are not within tau of the truth
  // (ECCV 2016, section 4). A copy of a right curve counts for nothing, one of a false curve again.
  // Samples are the cells of EvaluateCurves, or points.
  std::optional<double> sample_precision;
  // Share of the true length (or points) within tau of the reconstruction.
  std::optional<double> recall;
  // Harmonic mean of the two.
  std::optional<double> f;
  // Mean and median distance of the reconstruction to the truth, and of the truth to the
  // reconstruction, in the unit of tau.
  std::optional<double> accuracy, median_accuracy;
  std::optional<double> completeness, median_completeness;
  // Share of the reconstructed length that runs alongside another link (duplicates.h).
  std::optional<double> duplicated;
  // The totals of the shares: length in world units, or points.
  double reconstructed_length = 0;
  double true_length = 0;
  // Shares of the junctions (nodes of degree >= 3) that the other set has, too.
  std::optional<double> junction_precision, junction_recall;
  int num_junctions = 0;
  int num_true_junctions = 0;
  // 95 % confidence intervals: bootstrap over links and true chains (curve_bootstrap.h).
  std::optional<Interval> precision_interval, recall_interval, f_interval;
  StructureScores structure;
  FeatureScores features;
};

struct EvaluationReport {
  std::vector<TauResult> rows;  // as options.taus; none if no curves were compared
  bool in_footprints = false;
  // Of the whole reconstruction, inside and outside the region.
  int num_links = 0;
  int num_points = 0;
  double total_length = 0;
  double mean_link_length = 0;
  int num_components = 0;
  std::map<int, int> nodes_by_degree;
  // Points ignored because the set has polylines.
  int num_ignored_points = 0;
  // Of all links. Filled in by callers that have views.
  std::optional<SawTeeth> saw_teeth;
  // Of a drawing with sigmas. Filled in by callers that have views and the graph.
  std::optional<NormalizedErrors> normalized_errors;
  // Of a drawing with confidences. Filled in by callers that have the graph.
  std::optional<Reliability> reliability;
  // Of a drawing. Filled in by callers that have the graph and true kinds.
  std::optional<KindConfusion> kinds;
  // Of the cameras that the curves were made with. Filled in by callers that have true ones.
  std::optional<CameraAccuracy> cameras;
  // Filled in by callers that have true surfaces.
  std::optional<FaceScores> faces;
  // Filled in by callers that have wireframes; then nothing else is compared.
  std::optional<HssScores> hss;
};

// Compares curves or points with ground truth. Both sets are cut into cells of at most tau/4 along
// their length and judged at the cells' middles; distances are to the other set's curves. All
// copies of an edge count, also in the truth; the duplicated share measures those in the
// reconstruction (duplicates.h). Every point counts as 1. An empty reconstruction has recall 0 and
// no precision. Throws OptionError, or InputError if the truth is empty or a point is not finite.
// Time: O(n log n) in the number of cells, that is, total length / tau, times the number of copies.
EvaluationReport EvaluateCurves(const CurveSet& reconstruction, const CurveSet& truth,
                                const EvaluationOptions& options, const CurveSet& dont_care = {},
                                const RunContext& context = {});

// The same with taus and distances in pixel footprints of these views: every distance is divided by
// PixelFootprint at the sample it is measured from.
EvaluationReport EvaluateCurvesInFootprints(const CurveSet& reconstruction, const CurveSet& truth,
                                            const std::vector<View>& views,
                                            const EvaluationOptions& options,
                                            const CurveSet& dont_care = {},
                                            const RunContext& context = {});

// The part of the report that needs no truth, without rows. Linear in the number of points.
EvaluationReport CountCurves(const CurveSet& reconstruction);

}  // namespace limn
