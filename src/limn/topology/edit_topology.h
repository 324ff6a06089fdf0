#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/model/edgel_fate.h"
#include "limn/topology/meetings.h"
#include "limn/topology/tidy.h"
#include "limn/util/parallel.h"

namespace limn {

struct CompletionCounts {
  int64_t samples_doubtful = 0;  // of the sketch, in links that the images do not support enough
  MeetingCounts meetings;
  int64_t grown = 0;        // edges grown from joints
  int64_t short_edges = 0;  // and found between two of them
  TidyCounts tidy;
  SampleFates fates;
};

// What is ours of a drawing (not in the paper), between merging and refinement: links that the
// images do not support are removed, ends are joined across gaps, taken to corners, nodes and
// links, edges grow that the sketch does not have, and all is tidied. Links need vertices; the
// result has none but is finished (FinishLinks). The graph passes Validate() before and after.
CompletionCounts CompleteDrawing(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options,
                                 const std::optional<Eigen::AlignedBox3d>& box,
                                 const RunContext& context, DrawingGraph* graph);

struct RepairCounts {
  int64_t trimmed = 0;  // free ends that ran along another link
  MeetingCounts meetings;
  int64_t corners = 0;  // places where links turned sharply
};

// What a fit to the images makes visible of a drawing's topology, put right so that the next fit
// can use it: free ends are cut back where they run along other links, joined, and taken to what
// they meet; links are cut at corners. Links without vertices are left alone; the others need a
// point about every px. The graph passes Validate() before and after.
RepairCounts RepairTopology(const TopologyInput& input, const TopologyOptions& options,
                            DrawingGraph* graph);

}  // namespace limn
