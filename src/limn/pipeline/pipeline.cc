#include "limn/pipeline/pipeline.h"

#include <utility>

#include "limn/pipeline/sketch_views.h"

namespace limn {

UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end) {
  options.Check();

  CurvesResult image_curves = ExtractCurves({input.views, input.images, input.cache}, options.edges,
                                            options.linking, context);
  on_stage_end(image_curves.summary);

  SketchResult sketch =
      SketchViews(options.mode, {input.views, image_curves.curves, input.hints, input.box},
                  options.sketch, input.cache, context);
  on_stage_end(sketch.summary);

  DrawingResult drawing = BuildDrawing({input.views, image_curves.curves, sketch.sketch, input.box},
                                       options.drawing, context);
  on_stage_end(drawing.summary);
  return {std::move(image_curves), std::move(sketch), std::move(drawing)};
}

PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end) {
  auto [image_curves, sketch, drawing] = DrawUnrefined(input, options, context, on_stage_end);

  RefinementResult refined =
      RefineDrawing({input.views, image_curves.curves, drawing.graph, &input.hints.points},
                    options.refinement, context);
  on_stage_end(refined.summary);

  PrimitiveResult primitives =
      FitPrimitives(refined.graph, refined.cameras ? refined.cameras->views : input.views,
                    options.primitives, context);
  on_stage_end(primitives.summary);

  return {std::move(image_curves.curves), std::move(sketch.sketch),   std::move(sketch.fates),
          std::move(primitives.graph),    std::move(refined.cameras), std::move(drawing.fates)};
}

}  // namespace limn
