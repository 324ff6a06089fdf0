// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/paper_drawing.h"

#include <cmath>

#include "limn/paper/curve_averaging.h"
#include "limn/paper/link_fitting.h"
#include "limn/paper/merging.h"
#include "limn/paper/sketch_samples.h"
#include "limn/topology/finish_links.h"
#include "limn/topology/sample_fates.h"

namespace limn {
namespace {

// An edgel supports a sample within these limits, those of the default drawing.
constexpr SupportGate kGate = {1.0, 1.0, 15 * kDeg};

void Summarize(int num_clusters, const AveragingResult& averaging, const MergingCounts& merging,
               StageSummary* summary) {
  summary->in.insert(summary->in.end(),
                     {{"clusters", num_clusters},
                      {averaging.converged ? "averaging rounds until convergence"
                                           : "averaging rounds without convergence",
                       averaging.rounds},
                      {"largest movement in the last round, px/1000",
                       std::llround(1000 * averaging.last_move_px)}});
  summary->kept.insert(summary->kept.end(), {{"runs released", merging.released},
                                             {"elongations", merging.elongated},
                                             {"branchings", merging.branched},
                                             {"bridges", merging.bridged},
                                             {"rejoinings", merging.rejoined},
                                             {"multi-attachments", merging.multi_attached}});
}

}  // namespace

DrawingResult BuildPaperDrawing(const DrawingInput& input, const PaperOptions& options,
                                const TopologyOptions& topology, const RunContext& context) {
  options.Check();
  const auto edgels = BuildViewEdgels(input.scene.curves, context);
  const TopologyInput images = {input.scene.views, input.scene.curves, edgels, kGate,
                                input.scene.box};
  SampleSet samples = TakeSamples(input.sketch, images);
  const CurveConsistency network = BuildCurveConsistency(
      samples, BuildLocalConsistency(samples, input.scene.views.size(), options, context), options,
      context);
  const AveragingResult averaging = AverageCurves(network, options, context, &samples);
  MergingCounts merging;
  DrawingResult result;
  result.graph = MergeCurves(samples, network, input.scene.views, options, context, &merging);
  FitLinks(samples, network, &result.graph);
  result.fates = FatesOf(input.sketch, samples);
  UpdateFates(result.graph, EdgelFate::kNotTraced, &result.fates);
  FinishLinks(images, topology, &result.graph);
  result.summary = SummarizeDrawing(input.sketch, result.graph);
  Summarize(network.num_clusters, averaging, merging, &result.summary);
  return result;
}

}  // namespace limn
