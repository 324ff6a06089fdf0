#include "limn/drawing/drawing.h"

#include <algorithm>
#include <set>

#include "limn/drawing/corner_edges.h"
#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/graph_assembly.h"
#include "limn/drawing/junctions.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"
#include "limn/drawing/sample_fates.h"

namespace limn {
namespace {

int64_t NumClusters(const CurveConsistency& network) {
  return static_cast<int64_t>(std::set<int>(network.cluster.begin(), network.cluster.end()).size());
}

// Samples that curves of enough other primary views agree with.
std::vector<uint8_t> AgreedSamples(const std::vector<int>& agreeing_views,
                                   const DrawingOptions& options, int64_t* num_dropped) {
  std::vector<uint8_t> keep;
  for (const int count : agreeing_views) {
    keep.push_back(count >= options.min_primary_views);
    *num_dropped += !keep.back();
  }
  return keep;
}

// Mean along a link of the number of primary views that agree; points that were added have none to
// ask.
double MeanAgreement(const DraftLink& link, const std::vector<int>& agreeing_views) {
  double sum = 0;
  double length_px = 0;
  for (int k = 0; k < link.size(); ++k) {
    int here = 0;
    for (const int s : link.samples[k]) here = std::max(here, agreeing_views[s]);
    if (here == 0) continue;
    const double own_px = ArcPx(link, std::max(k - 1, 0), std::min(k + 1, link.size() - 1));
    sum += here * own_px;
    length_px += own_px;
  }
  return length_px > 0 ? sum / length_px : 0;
}

// Number of primary views that the samples of a link come from.
int NumPrimaryViews(const SampleSet& samples, const DraftLink& link) {
  std::set<ViewId> views;
  for (const auto& of_point : link.samples) {
    for (const int s : of_point) views.insert(samples.origins[samples.curve_of[s]].anchor_view);
  }
  return static_cast<int>(views.size());
}

// Remove the links that too few primary views agree with on the whole: in the mean along them, and
// in what was merged into them (curves that only agree may have been merged into another link).
// Returns the number of samples in them.
int64_t RemoveDoubtfulLinks(const SampleSet& samples, const std::vector<int>& agreeing_views,
                            const DrawingOptions& options, Draft* draft) {
  int64_t num_samples = 0;
  std::vector<uint8_t> keep;
  for (const DraftLink& link : draft->links) {
    keep.push_back(MeanAgreement(link, agreeing_views) >= options.min_link_primary_views &&
                   NumPrimaryViews(samples, link) >= options.min_primary_views);
    if (!keep.back()) num_samples += draft->NumSketchSamples(link);
  }
  KeepLinks(keep, draft);
  return num_samples;
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
  const std::vector<int> agreeing_views = CountAgreeingViews(samples, network);
  const std::vector<uint8_t> keep = AgreedSamples(agreeing_views, options, &not_agreed);
  const int rounds = AverageCurves(network, options, context, &samples);
  const MergedCurves merged = MergeCurves(samples, network, keep, input.views, options);
  Draft draft = FitLinks(samples, merged, options);
  SampleLedger ledger(samples, keep);
  ledger.Update(draft, EdgelFate::kPrunedLink);
  const int64_t doubtful = RemoveDoubtfulLinks(samples, agreeing_views, options, &draft);
  ledger.Update(draft, EdgelFate::kDoubtfulLink);
  JunctionCounts junctions;
  JoinLinks(samples, input.views, evidence, options, &draft, &junctions);
  const int64_t grown = GrowCornerEdges(input.views, input.curves,
                                        IndexEdgels(input.curves, evidence, samples, draft),
                                        input.box, options, &samples, &draft);
  JoinLinks(samples, input.views, evidence, options, &draft, &junctions);  // ends that grew
  const int64_t short_edges =
      AddShortEdges(input.views, input.curves, IndexEdgels(input.curves, evidence, samples, draft),
                    options, &samples, &draft);
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
                  {"dissolved nodes", cleanup.dissolved_nodes}};
  summary.dropped = {
      {"samples: too few views after re-triangulation", retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", retriangulation.piece_too_short},
      {"samples: no other primary view agrees", not_agreed},
      {"samples: in links that few primary views agree with", doubtful},
      {"samples: in short links", cleanup.samples_pruned},
      {"samples: in links that run along others", cleanup.samples_covered},
      {"meetings without image evidence", junctions.without_image_evidence}};
  return result;
}

}  // namespace limn
