#include "limn/drawing/drawing.h"

#include <algorithm>
#include <set>

#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/graph_assembly.h"
#include "limn/drawing/junctions.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"

namespace limn {
namespace {

int64_t NumClusters(const CurveConsistency& network) {
  return static_cast<int64_t>(
      std::set<int>(network.cluster.begin(), network.cluster.end()).size());
}

// Samples that curves of enough other primary views agree with.
std::vector<uint8_t> AgreedSamples(const SampleSet& samples, const CurveConsistency& network,
                                   const DrawingOptions& options, int64_t* num_dropped) {
  std::vector<uint8_t> keep;
  for (const int count : CountAgreeingViews(samples, network)) {
    keep.push_back(count >= options.min_primary_views);
    *num_dropped += !keep.back();
  }
  return keep;
}

}  // namespace

DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context) {
  options.Check();
  const auto evidence = BuildEvidence(input.views, input.curves, options.Gate(), context);
  RetriangulationStats retriangulation;
  SampleSet samples = Retriangulate(input.sketch, input.views, input.curves, evidence, options,
                                    context, &retriangulation);
  const LocalConsistency local = BuildLocalConsistency(samples, input.curves, options, context);
  const CurveConsistency network = BuildCurveConsistency(samples, local, options, context);
  int64_t not_agreed = 0;
  const std::vector<uint8_t> keep = AgreedSamples(samples, network, options, &not_agreed);
  const int rounds = AverageCurves(network, options, context, &samples);
  const MergedCurves merged = MergeCurves(samples, network, keep, input.views, options);
  Draft draft = FitLinks(samples, merged, options);
  const JunctionCounts junctions = JoinLinks(samples, input.views, evidence, options, &draft);
  const CleanupCounts cleanup = CleanUp(options, &draft);

  DrawingResult result;
  result.graph = AssembleGraph(samples, input.views, input.curves, options, draft);
  int64_t in_links = 0;
  for (const DrawingLink& link : result.graph.links) {
    for (const LinkMember& member : link.members) in_links += member.end - member.begin;
  }
  int64_t num_junctions = 0;
  for (const DrawingNode& node : result.graph.nodes) {
    num_junctions += node.kind == NodeKind::kJunction;
  }
  StageSummary& summary = result.summary;
  summary.stage = "drawing";
  summary.in = {{"curves", static_cast<int64_t>(input.sketch.curves.size())},
                {"samples", retriangulation.samples_in},
                {"clusters", NumClusters(network)},
                {"averaging rounds", rounds}};
  summary.kept = {{"samples", in_links},
                  {"links", static_cast<int64_t>(result.graph.links.size())},
                  {"nodes", static_cast<int64_t>(result.graph.nodes.size())},
                  {"junctions", num_junctions},
                  {"runs released", merged.counts.released},
                  {"elongations", merged.counts.elongated},
                  {"branchings", merged.counts.branched},
                  {"bridges", merged.counts.bridged},
                  {"rejoinings", merged.counts.rejoined},
                  {"multi-attachments", merged.counts.multi_attached},
                  {"continuations", junctions.continued},
                  {"corners", junctions.corners},
                  {"T junctions", junctions.t_junctions},
                  {"ends joined to nodes", junctions.joined_nodes},
                  {"dissolved nodes", cleanup.dissolved_nodes}};
  summary.dropped = {
      {"samples: too few views after re-triangulation", retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", retriangulation.piece_too_short},
      {"samples: no other primary view agrees", not_agreed},
      {"samples: in short links", cleanup.samples_pruned},
      {"samples: in links that run along others", cleanup.samples_covered},
      {"meetings without image evidence", junctions.without_image_evidence}};
  return result;
}

}  // namespace limn
