// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/refinement/refinement_input.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct RefinementResult {
  DrawingGraph graph;
  // Per link whether enough views show it to be fitted; empty without rounds.
  std::vector<uint8_t> fitted;
  StageSummary summary;
};

// Fits the drawing to all images at once (ours; algorithm/refinement.md). Each round matches every
// link with the edgels near its reprojections, then moves control points along all links to bring
// the reprojections onto the tangent lines of their edgels: robust least squares over all views.
// Links that meet share the control point at their node. A penalty on bending, except across
// corners, decides only what the edgels leave open. Only the supporting views of a link are used,
// and edgels whose brighter side differs from nearly all others are left out, since they belong to
// the other side of a thin bar. Views in which two links run so near to each other that their edges
// blur are ignored where enough others remain (crowding.h). After half of the rounds, covered links
// are removed and the topology is repaired (RepairTopology). All links are taken for edges: the
// graph has neither rods nor outlines. Sigmas come from the inverse normal matrix, scaled by how
// well the views agree (variance_factors.h). Links that too few views show keep their shape, with
// sigmas of at least max_distance_px. The result passes Validate(). Throws OptionError and
// Cancelled. Time: rounds times length of all links in px times views.
RefinementResult RefineDrawing(const RefinementInput& input, const RefinementOptions& options,
                               const TopologyOptions& topology, const RunContext& context);

// A place on a link, and the number of views with edgels that it was fitted to there.
struct ShownPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int num_views = 0;
};

struct RefitResult {
  DrawingGraph graph;
  // Per link, whether it was fitted: requested, and shown by enough views.
  std::vector<uint8_t> fitted;
  // For each requested link, fitted or not: places along it, every 1.5 px.
  std::vector<std::vector<ShownPlace>> shown;
};

// Fits some links of a drawing (`refit`, one per link) to the images again, as RefineDrawing does,
// and gives them new supporting views. All else stays as it is, bit for bit: cameras, topology,
// other links, and the nodes that these end at. Links without enough views, and outlines of smooth
// bodies, keep their shape. The result passes Validate(). Throws OptionError and Cancelled. Time:
// as RefineDrawing, but links that stay are matched only.
RefitResult RefitLinks(const RefinementInput& input, const std::vector<uint8_t>& refit,
                       const RefinementOptions& options, const RunContext& context);

}  // namespace limn
