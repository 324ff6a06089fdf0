#include "limn/drawing/drawing.h"

#include <algorithm>
#include <set>

#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/link_fitting.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"
#include "limn/topology/edit_topology.h"

namespace limn {
namespace {

int64_t NumClusters(const CurveConsistency& network) {
  return static_cast<int64_t>(std::set<int>(network.cluster.begin(), network.cluster.end()).size());
}

// The drawing of the paper, with counts for the summary.
struct MergedSketch {
  DrawingGraph graph;
  RetriangulationStats retriangulation;
  int64_t num_clusters = 0;
  int averaging_rounds = 0;
  MergingCounts merging;
};

MergedSketch MergeSketch(const DrawingInput& input, const TopologyInput& images,
                         const DrawingOptions& options, const RunContext& context) {
  MergedSketch result;
  SampleSet samples = Retriangulate(input.sketch, input.views, input.curves, images.edgels, options,
                                    context, &result.retriangulation);
  const CurveConsistency network = BuildCurveConsistency(
      samples, BuildLocalConsistency(samples, input.curves, options, context), options, context);
  result.num_clusters = NumClusters(network);
  const std::vector<int> agreeing_views = CountAgreeingViews(samples, network);
  result.averaging_rounds = AverageCurves(network, options, context, &samples);
  MergedCurves merged = MergeCurves(samples, network, input.views, options, context);
  result.merging = merged.counts;
  result.graph = std::move(merged.graph);
  FitLinks(samples, agreeing_views, options, &result.graph);
  return result;
}

StageSummary Summarize(const DrawingInput& input, const MergedSketch& merged,
                       const CompletionCounts& completion, const DrawingGraph& graph) {
  int64_t samples_in_links = 0;
  for (const DrawingLink& link : graph.links) {
    for (const LinkMember& member : link.members) samples_in_links += member.end - member.begin;
  }
  const auto num_junctions =
      std::count_if(graph.nodes.begin(), graph.nodes.end(),
                    [](const DrawingNode& node) { return node.kind == NodeKind::kJunction; });
  const MergingCounts& merging = merged.merging;
  const MeetingCounts& meetings = completion.meetings;
  StageSummary summary;
  summary.stage = "drawing";
  summary.in = {{"curves", static_cast<int64_t>(input.sketch.curves.size())},
                {"samples", merged.retriangulation.samples_in},
                {"clusters", merged.num_clusters},
                {"averaging rounds", merged.averaging_rounds}};
  summary.kept = {{"samples", samples_in_links},
                  {"links", static_cast<int64_t>(graph.links.size())},
                  {"nodes", static_cast<int64_t>(graph.nodes.size())},
                  {"junctions", num_junctions},
                  {"runs released", merging.released},
                  {"elongations", merging.elongated},
                  {"branchings", merging.branched},
                  {"bridges", merging.bridged},
                  {"rejoinings", merging.rejoined},
                  {"multi-attachments", merging.multi_attached},
                  {"continuations", meetings.joined},
                  {"corners", meetings.corners},
                  {"T junctions", meetings.to_links},
                  {"ends joined to nodes", meetings.to_nodes},
                  {"edges grown from corners", completion.grown},
                  {"short edges between nodes", completion.short_edges},
                  {"forks cut", completion.tidy.forks_cut},
                  {"dissolved nodes", completion.tidy.dissolved_nodes}};
  summary.dropped = {
      {"samples: too few views after re-triangulation", merged.retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", merged.retriangulation.piece_too_short},
      {"samples: in links with too little support", completion.samples_doubtful},
      {"samples: in short links", completion.tidy.samples_short},
      {"samples: in links that run along others", completion.tidy.samples_covered},
      {"meetings that the images do not show", meetings.refused}};
  return summary;
}

}  // namespace

DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context) {
  options.Check();
  const auto edgels = BuildViewEdgels(input.curves, context);
  const TopologyInput images = {input.views, input.curves, edgels, options.Gate(), input.box};
  MergedSketch merged = MergeSketch(input, images, options, context);
  DrawingResult result;
  result.graph = std::move(merged.graph);
  CompletionCounts completion =
      CompleteDrawing(images, input.sketch, options.topology, context, &result.graph);
  result.summary = Summarize(input, merged, completion, result.graph);
  result.fates = std::move(completion.fates);
  return result;
}

}  // namespace limn
