// SPDX-License-Identifier: BSD-3-Clause
#include "bench/run_stages.h"

#include "limn/belief/confidence.h"
#include "limn/belief/link_judge.h"
#include "limn/belief/short_curves.h"
#include "limn/belief/tri_angle.h"
#include "limn/drawing/drawing.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/kinds/smooth_outlines.h"
#include "limn/kinds/texture.h"
#include "limn/model/link_selection.h"
#include "limn/pipeline/build_sketch.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"
#include "limn/rods/find_rods.h"

namespace limn::bench {
namespace {

// Calls the stage, reports its cost, returns its result.
template <typename Stage, typename ToCurves>
auto Measure(const Stage& stage, const ToCurves& to_curves, const StageListener& on_stage_end) {
  const StageMeter meter;
  auto result = stage();
  const StageCost cost = meter.Finish(result.summary.stage);
  on_stage_end(cost, to_curves(result));
  return result;
}

}  // namespace

void RunStages(const Scene& scene, const std::function<Image(ViewId)>& read_image,
               const PipelineOptions& options, const RunContext& context,
               const StageListener& on_stage_end) {
  const auto of_graph = [](const auto& result) { return ToCurveSet(result.graph); };
  const SketchResult sketch = Measure(
      [&] {
        return BuildSketch(options.mode, {{scene.views, scene.curves, scene.hints}}, options.sketch,
                           context);
      },
      [](const SketchResult& result) { return ToCurveSet(result.sketch); }, on_stage_end);
  const DrawingResult drawing = Measure(
      [&] {
        return BuildDrawing({{scene.views, scene.curves}, sketch.sketch}, options.drawing, context);
      },
      of_graph, on_stage_end);
  const RefinementResult refined = Measure(
      [&] {
        return RefineDrawing({{scene.views, scene.curves, scene.hints}, drawing.graph},
                             options.refinement, options.drawing.topology, context);
      },
      of_graph, on_stage_end);
  const BeliefResult judged = Measure(
      [&] {
        return JudgeLinks({{scene.views, scene.curves},
                           refined.graph,
                           refined.fitted,
                           RefinementOptions().Gate()},
                          options.belief, options.drawing.topology, context);
      },
      of_graph, on_stage_end);
  // Truth has the outlines of rods.
  const auto as_seen = [](const auto& result) {
    LinkSelection selection = LinkSelection::AsSeen();
    selection.kinds.fill(true);
    selection.tentative = true;
    return ToCurveSet(Selected(result.graph, selection));
  };
  const RodResult rods = Measure(
      [&] {
        return FindRods({{scene.views, scene.curves, scene.hints}, judged.graph}, context);
      },
      as_seen, on_stage_end);
  const OutlinesResult outlines = Measure(
      [&] {
        return FindSmoothOutlines({{scene.views, scene.curves, scene.hints}, rods.graph}, context);
      },
      as_seen, on_stage_end);
  const PrimitiveResult primitives = Measure(
      [&] { return FitPrimitives(outlines.graph, scene.views, options.primitives, context); },
      as_seen, on_stage_end);
  if (!read_image) return;
  const KindsResult kinds = Measure(
      [&] {
        return ClassifyKinds({scene.views, read_image, primitives.graph}, context);
      },
      as_seen, on_stage_end);
  const KindsResult marked = Measure(
      [&] {
        KindsResult result = kinds;
        MeasureCurves(scene.views, &result.graph);
        result.summary = MarkTexture(scene.views, &result.graph);
        return result;
      },
      as_seen, on_stage_end);
  Measure(
      [&] {
        KindsResult result = marked;
        MeasureDepth(scene.views, context, &result.graph);
        TellConfidences(scene.views, &result.graph);
        result.summary = DoubtShortCurves(scene.views, &result.graph);
        return result;
      },
      as_seen, on_stage_end);
}

}  // namespace limn::bench
