// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/drawing.h"

#include <algorithm>

#include "limn/drawing/link_smoothing.h"
#include "limn/drawing/retriangulation.h"
#include "limn/drawing/trace_curves.h"
#include "limn/model/sample_step.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/sample_fates.h"

namespace limn {
namespace {

struct DrawingCounts {
  RetriangulationStats retriangulation;
  TracingCounts tracing;
  CompletionCounts completion;
};

using Counts = decltype(StageSummary::in);

void Append(const Counts& more, Counts* counts) {
  counts->insert(counts->end(), more.begin(), more.end());
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

void Summarize(const DrawingCounts& counts, StageSummary* summary) {
  summary->dropped = {
      {"samples: too few views after re-triangulation", counts.retriangulation.too_few_views},
      {"samples: piece too short after re-triangulation", counts.retriangulation.piece_too_short}};
  SummarizeTracing(counts.tracing, summary);
  SummarizeCompletion(counts.completion, summary);
}

}  // namespace

StageSummary SummarizeDrawing(const CurveSketch& sketch, const DrawingGraph& graph) {
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
  return summary;
}

DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context) {
  options.Check();
  const auto edgels = BuildViewEdgels(input.scene.curves, context);
  const TopologyInput images = {input.scene.views, input.scene.curves, edgels, options.Gate(),
                                input.scene.box};
  DrawingCounts counts;
  DrawingResult result;
  {
    const SampleSet samples = Retriangulate(input.sketch, kVerticesPerSample, images, options,
                                            context, &counts.retriangulation);
    result.fates = FatesOf(input.sketch, samples);
    result.graph = TraceCurves(samples, options.tracing, context, &counts.tracing);
  }
  SmoothLinks(options.bending_sigma_px, &result.graph);
  UpdateFates(result.graph, EdgelFate::kNotTraced, &result.fates);
  counts.completion = CompleteDrawing(images, input.sketch, options.topology, context,
                                      &result.graph, &result.fates);
  result.summary = SummarizeDrawing(input.sketch, result.graph);
  Summarize(counts, &result.summary);
  return result;
}

}  // namespace limn
