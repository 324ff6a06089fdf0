// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Counts samples of the sketch; a sample that is moved may stand for several.
struct RetriangulationStats {
  int64_t samples_in = 0;
  int64_t too_few_views = 0;    // support lost when the sample moved
  int64_t piece_too_short = 0;  // in pieces between such samples that are too short
};

// Moves samples of the sketch, one for about `vertices_per_sample` vertices of the image curve that
// they were made from, to where the tangent lines of all their supporting edgels agree (ours;
// algorithm/drawing.md#re-triangulation): robust least squares of the distances in all views,
// across the curve only. This alternates with smoothing along the curve, in which samples are
// weighted by their inverse covariances, and with a new choice of supporting edgels. Curves are cut
// where support is lost. bending_sigma_px is that of neighboring vertices. Time: samples times
// views.
SampleSet Retriangulate(const CurveSketch& sketch, int vertices_per_sample,
                        const TopologyInput& images, const DrawingOptions& options,
                        const RunContext& context, RetriangulationStats* stats);

}  // namespace limn
