#include "limn/drawing/drawing.h"

#include <set>

#include "limn/drawing/corner_edges.h"
#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/graph_assembly.h"
#include "limn/drawing/junctions.h"
#include "limn/drawing/link_evidence.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"
#include "limn/drawing/sample_fates.h"

namespace limn {
namespace {

int64_t NumClusters(const CurveConsistency& network) {
  return static_cast<int64_t>(std::set<int>(network.cluster.begin(), network.cluster.end()).size());
}

// Returns the number of samples in the links removed.
int64_t RemoveDoubtfulLinks(const std::vector<uint8_t>& believed, Draft* draft) {
  int64_t num_samples = 0;
  for (size_t l = 0; l < believed.size(); ++l) {
    if (!believed[l]) num_samples += draft->NumSketchSamples(draft->links[l]);
  }
  KeepLinks(believed, draft);
  return num_samples;
}

}  // namespace

DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context) {
  options.Check();
  const auto evidence = BuildEvidence(input.curves, context);
  RetriangulationStats retriangulation;
  SampleSet samples = Retriangulate(input.sketch, input.views, input.curves, evidence, options,
                                    context, &retriangulation);
  const CurveConsistency network = BuildCurveConsistency(
      samples, BuildLocalConsistency(samples, input.curves, options, context), options, context);
  const std::vector<int> agreeing_views = CountAgreeingViews(samples, network);
  const int rounds = AverageCurves(network, options, context, &samples);
  const MergedCurves merged = MergeCurves(samples, network, input.views, options, context);
  Draft draft = FitLinks(samples, merged, options);
  SampleLedger ledger(samples);
  ledger.Update(draft, EdgelFate::kPrunedLink);
  const int64_t doubtful = RemoveDoubtfulLinks(
      BelievedLinks({samples, agreeing_views, input.views, input.curves, evidence}, options, draft,
                    context),
      &draft);
  ledger.Update(draft, EdgelFate::kDoubtfulLink);
  JunctionCounts junctions;
  JoinLinks(samples, input.views, evidence, options, &draft, &junctions);
  const int64_t grown = GrowCornerEdges(input.views, input.curves,
                                        IndexEdgels(input.curves, evidence, samples, draft),
                                        input.box, options, context, &samples, &draft);
  JoinLinks(samples, input.views, evidence, options, &draft, &junctions);  // ends that grew
  const int64_t short_edges =
      AddShortEdges(input.views, input.curves, IndexEdgels(input.curves, evidence, samples, draft),
                    options, context, &samples, &draft);
  const CleanupCounts cleanup = CleanUp(options, &draft);
  ledger.Update(draft, EdgelFate::kPrunedLink);

  DrawingResult result;
  result.fates = ledger.ForSketch(samples, input.sketch);
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
                  {"edges grown from corners", grown},
                  {"short edges between nodes", short_edges},
                  {"forks cut", cleanup.forks_cut},
                  {"dissolved nodes", cleanup.dissolved_nodes}};
  summary.dropped = {
      {"samples: too few views after re-triangulation", retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", retriangulation.piece_too_short},
      {"samples: in links with too little evidence", doubtful},
      {"samples: in short links", cleanup.samples_pruned},
      {"samples: in links that run along others", cleanup.samples_covered},
      {"meetings without image evidence", junctions.without_image_evidence}};
  return result;
}

}  // namespace limn
