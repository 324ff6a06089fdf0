#include "limn/drawing/drawing.h"

#include <algorithm>
#include <cmath>

#include "limn/drawing/curve_averaging.h"
#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/link_fitting.h"
#include "limn/drawing/merging.h"
#include "limn/drawing/retriangulation.h"
#include "limn/drawing/sketch_samples.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/finish_links.h"
#include "limn/topology/sample_fates.h"
#include "limn/topology/trace_curves.h"

namespace limn {
namespace {

struct DrawingCounts {
  RetriangulationStats retriangulation;
  TracingCounts tracing;
  int64_t clusters = 0;
  AveragingResult averaging;
  MergingCounts merging;
  CompletionCounts completion;
};

// Samples of the sketch are about a pixel apart in each view that sees an edge. Half of them say as
// much (ALGORITHM.md 22.2).
constexpr int kTracedStep = 2;

DrawingGraph MergeSamples(const TopologyInput& images, const DrawingOptions& options,
                          const RunContext& context, SampleSet* samples, DrawingCounts* counts) {
  const CurveConsistency network = BuildCurveConsistency(
      *samples, BuildLocalConsistency(*samples, images.curves, options, context), options, context);
  counts->clusters = network.num_clusters;
  counts->averaging = AverageCurves(network, options, context, samples);
  DrawingGraph graph =
      MergeCurves(*samples, network, images.views, options, context, &counts->merging);
  FitLinks(*samples, network, options, &graph);
  return graph;
}

SampleFates FatesOf(const CurveSketch& sketch, const SampleSet& samples) {
  SampleFates fates;
  for (const Curve3D& curve : sketch.curves) {
    fates.emplace_back(curve.size(), EdgelFate::kLostSupport);
  }
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const LinkMember run = samples.InSketch(s);
    std::fill_n(fates[run.curve].begin() + run.begin, run.size(), EdgelFate::kDrawn);
  }
  return fates;
}

DrawingGraph MakeLinks(const CurveSketch& sketch, const TopologyInput& images,
                       const DrawingOptions& options, const RunContext& context,
                       DrawingCounts* counts, SampleFates* fates) {
  const bool traced = options.method == "traced";
  SampleSet samples = options.IsPaper() ? TakeSamples(sketch, images)
                                        : Retriangulate(sketch, traced ? kTracedStep : 1, images,
                                                        options, context, &counts->retriangulation);
  *fates = FatesOf(sketch, samples);
  if (!traced) {
    return MergeSamples(images, options, context, &samples, counts);
  }
  DrawingGraph graph = TraceCurves(samples, options.topology, context, &counts->tracing);
  SmoothLinks(options.bending_sigma_px, &graph);
  return graph;
}

using Counts = decltype(StageSummary::in);

void Append(const Counts& more, Counts* counts) {
  counts->insert(counts->end(), more.begin(), more.end());
}

// What the method that made the links did.
void SummarizeMerging(const DrawingCounts& counts, StageSummary* summary) {
  const MergingCounts& merging = counts.merging;
  Append({{"clusters", counts.clusters},
          {counts.averaging.converged ? "averaging rounds until convergence"
                                      : "averaging rounds without convergence",
           counts.averaging.rounds},
          {"largest movement in the last round, px/1000",
           std::llround(1000 * counts.averaging.last_move_px)}},
         &summary->in);
  Append({{"runs released", merging.released},
          {"elongations", merging.elongated},
          {"branchings", merging.branched},
          {"bridges", merging.bridged},
          {"rejoinings", merging.rejoined},
          {"multi-attachments", merging.multi_attached}},
         &summary->kept);
}

void SummarizeTracing(const TracingCounts& tracing, StageSummary* summary) {
  Append({{"traced curves", tracing.curves},
          {"traced curves that close", tracing.closed},
          {"ends of traced curves that meet one", tracing.meetings}},
         &summary->kept);
  Append({{"samples: on no traced curve", tracing.unclaimed}}, &summary->dropped);
}

void SummarizeCompletion(const CompletionCounts& completion, StageSummary* summary) {
  const MeetingCounts& meetings = completion.meetings;
  Append({{"ends continued", completion.continued.ends},
          {"px added to them", completion.continued.length_px},
          {"continuations", meetings.joined},
          {"corners", meetings.corners},
          {"T junctions", meetings.to_links},
          {"ends joined to nodes", meetings.to_nodes},
          {"nodes made at side edges", completion.side_nodes},
          {"edges grown from joints", completion.grown},
          {"short edges between nodes", completion.short_edges},
          {"forks cut", completion.tidy.forks_cut},
          {"dissolved nodes", completion.tidy.dissolved_nodes}},
         &summary->kept);
  Append({{"samples: in links with too little support", completion.samples_doubtful},
          {"samples: in short links", completion.tidy.samples_short},
          {"samples: in links that run along others", completion.tidy.samples_covered},
          {"meetings that the images do not show", meetings.refused}},
         &summary->dropped);
}

int64_t NumSamples(const CurveSketch& sketch) {
  int64_t count = 0;
  for (const Curve3D& curve : sketch.curves) count += static_cast<int64_t>(curve.size());
  return count;
}

StageSummary Summarize(const CurveSketch& sketch, const DrawingOptions& options,
                       const DrawingCounts& counts, const DrawingGraph& graph) {
  int64_t samples_in_links = 0;
  for (const DrawingLink& link : graph.links) {
    for (const LinkMember& member : link.members) samples_in_links += member.size();
  }
  const auto num_junctions =
      std::count_if(graph.nodes.begin(), graph.nodes.end(),
                    [](const DrawingNode& node) { return node.kind == NodeKind::kJunction; });
  StageSummary summary;
  summary.stage = "drawing";
  summary.in = {{"curves", static_cast<int64_t>(sketch.curves.size())},
                {"samples", NumSamples(sketch)}};
  summary.kept = {{"samples", samples_in_links},
                  {"links", static_cast<int64_t>(graph.links.size())},
                  {"nodes", static_cast<int64_t>(graph.nodes.size())},
                  {"junctions", num_junctions}};
  if (!options.IsPaper()) {
    summary.dropped = {
        {"samples: too few views after re-triangulation", counts.retriangulation.too_few_views},
        {"samples: piece too short after re-triangulation",
         counts.retriangulation.piece_too_short}};
  }
  if (options.method == "traced") {
    SummarizeTracing(counts.tracing, &summary);
  } else {
    SummarizeMerging(counts, &summary);
  }
  if (!options.IsPaper()) SummarizeCompletion(counts.completion, &summary);
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
  result.graph = MakeLinks(input.sketch, images, options, context, &counts, &result.fates);
  UpdateFates(result.graph, EdgelFate::kNotTraced, &result.fates);
  if (options.IsPaper()) {
    FinishLinks(images, options.topology, &result.graph);
  } else {
    counts.completion = CompleteDrawing(images, input.sketch, options.topology, context,
                                        &result.graph, &result.fates);
  }
  result.summary = Summarize(input.sketch, options, counts, result.graph);
  return result;
}

}  // namespace limn
