#include "limn/topology/edit_topology.h"

#include "limn/topology/covered_links.h"
#include "limn/topology/finish_links.h"
#include "limn/topology/grow_edges.h"
#include "limn/topology/join_ends.h"
#include "limn/topology/sample_fates.h"
#include "limn/topology/snap_ends.h"
#include "limn/topology/split_corners.h"
#include "limn/topology/verify_links.h"

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
                                 DrawingGraph* graph) {
  CompletionCounts counts;
  GraphEditor editor(graph);
  const MeetingTask meetings = {input, options, Reach::Drawn(options), &editor, &counts.meetings};
  for (const Curve3D& curve : sketch.curves) {
    counts.fates.emplace_back(curve.size(), EdgelFate::kDrawn);
  }
  UpdateFates(*graph, EdgelFate::kLostSupport, &counts.fates);
  counts.samples_doubtful =
      KeepAndCount(VerifyLinks(input, sketch, options, *graph, context), &editor);
  UpdateFates(*graph, EdgelFate::kDoubtfulLink, &counts.fates);
  MeetEnds(meetings);
  counts.grown = GrowEdges(input, options, context, &editor);
  MeetEnds(meetings);  // grown links have new ends
  counts.short_edges = AddShortEdges(input, options, context, &editor);
  counts.tidy = Tidy(options, &editor);
  UpdateFates(*graph, EdgelFate::kPrunedLink, &counts.fates);
  FinishLinks(input, options, graph);
  return counts;
}

RepairCounts RepairTopology(const TopologyInput& input, const TopologyOptions& options,
                            DrawingGraph* graph) {
  RepairCounts counts;
  GraphEditor editor(graph);
  const MeetingTask meetings = {input, options, Reach::Fitted(options), &editor, &counts.meetings};
  counts.trimmed = TrimEnds(options, &editor);
  JoinFacingEnds(meetings);
  SnapEnds(meetings);
  counts.splits = SplitAtCorners(&editor);
  PairContinuations(options, graph);
  return counts;
}

}  // namespace limn
