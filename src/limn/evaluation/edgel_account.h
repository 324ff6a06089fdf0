// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/util/parallel.h"

namespace limn {

// The input of an account: the results of all stages of one run.
struct AccountInput {
  CurvesScene scene;
  const EdgelFates& sketch_fates;
  const CurveSketch& sketch;
  const SampleFates& sample_fates;
  const DrawingGraph& graph;
};

// What became of every edgel of every view: drawn (kDrawn), within 1.5 px and 20 degrees of the
// projection of a link that the view supports (kExplained), or the stage that dropped it. Time:
// edgels + projected length of the drawing.
EdgelFates AccountEdgels(const AccountInput& input, const RunContext& context);

// Writes a header line, then one line per view and one for all with the number of edgels of each
// fate, comma-separated.
void WriteAccountCsv(const std::vector<View>& views, const EdgelFates& fates, std::ostream& out);

}  // namespace limn
