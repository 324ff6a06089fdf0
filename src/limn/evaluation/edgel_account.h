#pragma once

#include <iosfwd>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/util/parallel.h"

namespace limn {

// What an account is made from: the results of the stages, all of one run.
struct AccountInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const EdgelFates& sketch_fates;
  const CurveSketch& sketch;
  const SampleFates& sample_fates;
  const DrawingGraph& graph;
};

// What became of every edgel of every view: whether the drawing holds it (kDrawn) or projects onto
// it from a link that the view supports (kExplained: within 1.5 px and 20 degrees), and for all
// others the stage that lost them. Time: edgels + projected length of the drawing.
EdgelFates AccountEdgels(const AccountInput& input, const RunContext& context);

// One line per view and one for all: the number of edgels of each fate, with a header line; comma
// separated.
void WriteAccountCsv(const std::vector<View>& views, const EdgelFates& fates, std::ostream& out);

}  // namespace limn
