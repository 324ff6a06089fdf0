#include "limn/drawing/drawing.h"

#include <algorithm>
#include <cmath>

#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/link_fitting.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"
#include "limn/topology/edit_topology.h"

namespace limn {
namespace {

struct DrawingCounts {
  RetriangulationStats retriangulation;
  int64_t clusters = 0;
  AveragingResult averaging;
  MergingCounts merging;
  CompletionCounts completion;
};

// The drawing of the paper.
DrawingGraph MergeSketch(const CurveSketch& sketch, const TopologyInput& images,
                         const DrawingOptions& options, const RunContext& context,
                         DrawingCounts* counts) {
  SampleSet samples = Retriangulate(sketch, images, options, context, &counts->retriangulation);
  const CurveConsistency network = BuildCurveConsistency(
      samples, BuildLocalConsistency(samples, images.curves, options, context), options, context);
  counts->clusters = network.num_clusters;
  counts->averaging = AverageCurves(network, options, context, &samples);
  DrawingGraph graph =
      MergeCurves(samples, network, images.views, options, context, &counts->merging);
  FitLinks(samples, network, options, &graph);
  return graph;
}

StageSummary Summarize(const CurveSketch& sketch, const DrawingCounts& counts,
                       const DrawingGraph& graph) {
  int64_t samples_in_links = 0;
  for (const DrawingLink& link : graph.links) {
    for (const LinkMember& member : link.members) samples_in_links += member.end - member.begin;
  }
  const auto num_junctions =
      std::count_if(graph.nodes.begin(), graph.nodes.end(),
                    [](const DrawingNode& node) { return node.kind == NodeKind::kJunction; });
  const MergingCounts& merging = counts.merging;
  const CompletionCounts& completion = counts.completion;
  const MeetingCounts& meetings = completion.meetings;
  StageSummary summary;
  summary.stage = "drawing";
  summary.in = {{"curves", static_cast<int64_t>(sketch.curves.size())},
                {"samples", counts.retriangulation.samples_in},
                {"clusters", counts.clusters},
                {counts.averaging.converged ? "averaging rounds until convergence"
                                            : "averaging rounds without convergence",
                 counts.averaging.rounds},
                {"largest movement in the last round, px/1000",
                 std::llround(1000 * counts.averaging.last_move_px)}};
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
                  {"edges grown from joints", completion.grown},
                  {"short edges between nodes", completion.short_edges},
                  {"forks cut", completion.tidy.forks_cut},
                  {"dissolved nodes", completion.tidy.dissolved_nodes}};
  summary.dropped = {
      {"samples: too few views after re-triangulation", counts.retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", counts.retriangulation.piece_too_short},
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
  DrawingCounts counts;
  DrawingResult result;
  result.graph = MergeSketch(input.sketch, images, options, context, &counts);
  counts.completion =
      CompleteDrawing(images, input.sketch, options.topology, context, &result.graph);
  result.summary = Summarize(input.sketch, counts, result.graph);
  result.fates = std::move(counts.completion.fates);
  return result;
}

}  // namespace limn
