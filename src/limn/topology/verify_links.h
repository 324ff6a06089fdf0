#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

// The verdict for the outline of a smooth body.
constexpr uint8_t kIsContour = 2;

struct LinkVerdicts {
  std::vector<uint8_t> verdicts;           // per link: 1 = keep, 0 = do not, or kIsContour
  std::vector<double> contour_confidence;  // per link; 0 where it is not a contour
};

// Decides which links to keep (ours; algorithm/topology.md#rules). A link must
// stand for samples of at least two primary views. Occluding contours
// (occluding_contours.h) are set apart. A link is certain when enough primary views agree with it,
// averaged over its length (primary_views_share). Any other link must explain edgels that no
// certain link explains: it is kept if such edgels run along it in enough more views than edgels
// run along copies of it shifted sideways, which measure chance (own_views_share). Time: points of
// all links times views; ten times as much for uncertain links.
LinkVerdicts VerifyLinks(const TopologyInput& input, const CurveSketch& sketch,
                         const TopologyOptions& options, const DrawingGraph& graph,
                         const RunContext& context);

}  // namespace limn
