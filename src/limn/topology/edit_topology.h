// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/model/curve3d.h"
#include "limn/model/edgel_fate.h"
#include "limn/topology/coinciding_places.h"
#include "limn/topology/continue_curves.h"
#include "limn/topology/long_edges.h"
#include "limn/topology/meetings.h"
#include "limn/topology/tidy.h"
#include "limn/topology/whole_circles.h"
#include "limn/util/parallel.h"

namespace limn {

struct CompletionCounts {
  int64_t samples_doubtful = 0;  // sketch samples in links with too little support
  ContinuationCounts continued;
  MeetingCounts meetings;
  int64_t side_nodes = 0;   // nodes made where image edges end sideways at links
  int64_t grown = 0;        // links grown from joints
  int64_t short_edges = 0;  // links found between two joints
  TidyCounts tidy;
};

// Completes a traced drawing (ours; algorithm/topology.md). Removes links with too little support,
// extends links from their free ends, joins ends across gaps, at corners, at nodes and to links,
// grows edges that the sketch lacks, and tidies the result. Links need vertices; finished links
// (FinishLinks) have none.
// `fates` has those of the samples that are in no link, kDrawn for the others, before and after.
// The graph passes Validate() before and after.
CompletionCounts CompleteDrawing(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const RunContext& context,
                                 DrawingGraph* graph, SampleFates* fates);

struct RepairCounts {
  LongEdgeCounts long_edges;
  CircleCounts circles;
  int64_t trimmed = 0;  // free ends cut back from another link
  MeetingCounts meetings;
  int64_t splits = 0;       // of links where they turn sharply
  int64_t grown = 0;        // links grown from one joint to another
  int64_t short_edges = 0;  // links found between two joints
  int64_t dissolved_nodes = 0;
  CoincidenceCounts coincidences;
};

// Repairs topological errors that a fit to the images reveals, so that the next fit can benefit
// (ours; algorithm/refinement.md#repairs-between-fits). Draws long edges between joints anew
// and circles whole, cuts back free ends that run along other links, joins ends, moves them to the
// nodes and links that they meet, splits links at corners, grows edges between the nodes, which are
// now in the right places, dissolves nodes where one curve continues, and makes nodes where links
// cross. Links without vertices are left alone; the others need a point about every px. The graph
// passes Validate() before and after.
RepairCounts RepairTopology(const TopologyInput& input, const TopologyOptions& options,
                            const RunContext& context, DrawingGraph* graph);

}  // namespace limn
