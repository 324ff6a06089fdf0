#include "limn/pipeline/pipeline.h"

#include <utility>

#include "limn/belief/link_judge.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/regularity/regularize.h"

namespace limn {

DrawnCurves DrawCurves(const CurvesScene& scene, const PipelineOptions& options,
                       const RunContext& context, const StageObserver& on_stage_end) {
  SketchResult sketch =
      SketchViews(options.mode, {scene.views, scene.curves, scene.hints, scene.box}, options.sketch,
                  scene.cache, context, scene.part);
  on_stage_end(sketch.summary);

  DrawingResult drawing =
      BuildDrawing({scene.views, scene.curves, sketch.sketch, scene.box}, options.drawing, context);
  on_stage_end(drawing.summary);
  return {std::move(sketch), std::move(drawing)};
}

UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end) {
  options.Check();
  CurvesResult image_curves = ExtractCurves({input.views, input.images, input.cache}, options.edges,
                                            options.linking, context);
  on_stage_end(image_curves.summary);
  DrawnCurves drawn =
      DrawCurves({input.views, input.hints, image_curves.curves, input.box, input.cache}, options,
                 context, on_stage_end);
  return {std::move(image_curves), std::move(drawn)};
}

JudgedDrawing RefineAndJudge(const RefinementInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end) {
  if (options.drawing.IsPaper()) return {input.graph, std::nullopt};
  RefinementResult refined =
      RefineDrawing(input, options.refinement, options.drawing.topology, context);
  on_stage_end(refined.summary);
  const std::vector<View>& views = refined.cameras ? refined.cameras->views : input.views;
  BeliefResult judged = JudgeLinks({views, input.curves, refined.graph, refined.fitted},
                                   options.belief, options.drawing.topology, context);
  on_stage_end(judged.summary);
  return {std::move(judged.graph), std::move(refined.cameras)};
}

DrawingGraph DescribeLinks(DrawingGraph graph, const std::vector<View>& views,
                           const std::function<Image(ViewId)>& read_image,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end) {
  if (options.drawing.IsPaper()) return graph;
  PrimitiveResult primitives = FitPrimitives(graph, views, options.primitives, context);
  on_stage_end(primitives.summary);
  graph = std::move(primitives.graph);
  if (read_image) {
    KindsResult kinds = ClassifyKinds({views, read_image, graph}, context);
    on_stage_end(kinds.summary);
    graph = std::move(kinds.graph);
  }
  if (!options.regularize) return graph;
  RegularityResult regular =
      Regularize(graph, views, options.regularity, options.primitives, context);
  on_stage_end(regular.summary);
  return std::move(regular.graph);
}

PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end) {
  auto [image_curves, drawn] = DrawUnrefined(input, options, context, on_stage_end);
  auto& [sketch, drawing] = drawn;
  // What follows is done by this process alone.
  RunContext alone = context;
  alone.team = nullptr;

  JudgedDrawing judged =
      RefineAndJudge({input.views, image_curves.curves, drawing.graph, &input.hints.points},
                     options, alone, on_stage_end);
  const std::vector<View>& views = judged.cameras ? judged.cameras->views : input.views;
  DrawingGraph graph = DescribeLinks(std::move(judged.graph), views, input.images.read, options,
                                     alone, on_stage_end);
  if (input.images.release) input.images.release();
  return {std::move(image_curves.curves), std::move(sketch.sketch),
          std::move(sketch.fates),        std::move(graph),
          std::move(judged.cameras),      std::move(drawing.fates)};
}

}  // namespace limn
