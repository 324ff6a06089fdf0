#pragma once

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Counts samples of the sketch; each sample that is moved stands for `step` of them.
struct RetriangulationStats {
  int64_t samples_in = 0;
  int64_t too_few_views = 0;    // support lost when the sample moved
  int64_t piece_too_short = 0;  // in pieces between such samples that are too short
};

// Moves every `step`-th sample of the sketch to where the tangent lines of all its supporting
// edgels agree (ours; algorithm/drawing.md#re-triangulation): robust least squares of the distances
// in all views, across the curve only. This alternates with smoothing along the curve, in which
// samples are weighted by their inverse covariances, and with a new choice of supporting edgels.
// Curves are cut where support is lost. bending_sigma_px is that of neighbors in the sketch. Time:
// samples times views.
SampleSet Retriangulate(const CurveSketch& sketch, int step, const TopologyInput& images,
                        const DrawingOptions& options, const RunContext& context,
                        RetriangulationStats* stats);

}  // namespace limn
