// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/edit_topology.h"

#include "limn/topology/coinciding_places.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/finish_links.h"
#include "limn/topology/grow_edges.h"
#include "limn/topology/join_ends.h"
#include "limn/topology/long_edges.h"
#include "limn/topology/sample_fates.h"
#include "limn/topology/side_edges.h"
#include "limn/topology/snap_ends.h"
#include "limn/topology/split_corners.h"
#include "limn/topology/verify_links.h"
#include "limn/topology/whole_circles.h"

namespace limn {
namespace {

void MeetEnds(const MeetingTask& task) {
  task.counts->refused = 0;
  JoinFacingEnds(task);
  JoinCorners(task);
  SnapEnds(task);
}

}  // namespace

CompletionCounts CompleteDrawing(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const RunContext& context,
                                 DrawingGraph* graph, SampleFates* fates) {
  CompletionCounts counts;
  GraphEditor editor(graph);
  const MeetingTask meetings = {input, options, Reach::Drawn(options), &editor, &counts.meetings};
  counts.samples_doubtful =
      KeepAndCount(VerifyLinks(input, sketch, options, *graph, context), &editor);
  UpdateFates(*graph, EdgelFate::kDoubtfulLink, fates);
  counts.continued = ContinueCurves(input, options, context, &editor);
  MeetEnds(meetings);
  counts.side_nodes = SplitAtSideEdges(input, context, &editor);
  counts.grown = GrowEdges(input, options, GrowthEnd::kAnywhere, context, &editor);
  MeetEnds(meetings);  // grown links have new ends
  counts.short_edges = AddShortEdges(input, options, context, &editor);
  counts.tidy = Tidy(options, &editor);
  UpdateFates(*graph, EdgelFate::kPrunedLink, fates);
  FinishLinks(input, options, graph);
  return counts;
}

RepairCounts RepairTopology(const TopologyInput& input, const TopologyOptions& options,
                            const RunContext& context, DrawingGraph* graph) {
  RepairCounts counts;
  GraphEditor editor(graph);
  const MeetingTask meetings = {input, options, Reach::Fitted(options), &editor, &counts.meetings};
  counts.long_edges = AddLongEdges(input, context, &editor);
  counts.circles = CompleteCircles(input, context, &editor);
  counts.trimmed = TrimEnds(options, &editor);
  JoinFacingEnds(meetings);
  SnapEnds(meetings);
  counts.splits = SplitAtCorners(&editor);
  counts.grown = GrowEdges(input, options, GrowthEnd::kJoint, context, &editor);
  counts.short_edges = AddShortEdges(input, options, context, &editor);
  counts.dissolved_nodes = DissolveNodes(options, &editor);
  counts.coincidences = UniteCoincidingPlaces(meetings);
  PairContinuations(options, graph);
  return counts;
}

}  // namespace limn
