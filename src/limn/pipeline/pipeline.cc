#include "limn/pipeline/pipeline.h"

#include <utility>

#include "limn/belief/link_judge.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/paper/paper_drawing.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/pipeline/update_scene.h"
#include "limn/regularity/regularize.h"

namespace limn {

DrawingResult DrawSketch(const DrawingInput& input, const PipelineOptions& options,
                         const RunContext& context) {
  return options.IsPaper() ? BuildPaperDrawing(input, options.paper, context)
                           : BuildDrawing(input, options.drawing, context);
}

DrawnCurves DrawCurves(const CurvesScene& scene, const PipelineOptions& options, ResultCache* cache,
                       const RunContext& context, const StageObserver& on_stage_end,
                       const std::string& part) {
  SketchResult sketch = SketchViews(options.mode, {scene}, options.sketch, cache, context, part);
  on_stage_end(sketch.summary);

  DrawingResult drawing = DrawSketch({scene, sketch.sketch}, options, context);
  on_stage_end(drawing.summary);
  return {std::move(sketch), std::move(drawing)};
}

namespace {

CurvesResult ExtractAll(const PipelineInput& input, const PipelineOptions& options,
                        const RunContext& context, const StageObserver& on_stage_end) {
  options.Check();
  CurvesResult image_curves = ExtractCurves({input.views, input.images, input.cache}, options.edges,
                                            options.linking, context);
  on_stage_end(image_curves.summary);
  return image_curves;
}

DrawnCurves DrawExtracted(const PipelineInput& input, const CurvesResult& image_curves,
                          const PipelineOptions& options, const RunContext& context,
                          const StageObserver& on_stage_end) {
  return DrawCurves({input.views, image_curves.curves, input.hints, input.box}, options,
                    input.cache, context, on_stage_end);
}

// If the drawing of an earlier run can be brought up to date; else says why not.
std::optional<PipelineResult> Update(const PipelineInput& input, CurvesResult* image_curves,
                                     const PipelineOptions& options, const RunContext& context,
                                     const StageObserver& on_stage_end) {
  std::string why_not;
  std::optional<PipelineResult> result =
      UpdateScene(input, &image_curves->curves, options, context, on_stage_end, &why_not);
  if (!result) {
    StageSummary summary;
    summary.stage = "update";
    summary.warnings = {"drawn from scratch: " + why_not};
    on_stage_end(summary);
  }
  return result;
}

}  // namespace

UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end) {
  CurvesResult image_curves = ExtractAll(input, options, context, on_stage_end);
  DrawnCurves drawn = DrawExtracted(input, image_curves, options, context, on_stage_end);
  return {std::move(image_curves), std::move(drawn)};
}

JudgedDrawing RefineAndJudge(const RefinementInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end) {
  if (options.IsPaper()) return {input.graph, std::nullopt};
  RefinementResult refined =
      RefineDrawing(input, options.refinement, options.drawing.topology, context);
  on_stage_end(refined.summary);
  const std::vector<View>& views = refined.cameras ? refined.cameras->views : input.scene.views;
  BeliefResult judged = JudgeLinks(
      {{views, input.scene.curves}, refined.graph, refined.fitted, options.refinement.Gate()},
      options.belief, options.drawing.topology, context);
  on_stage_end(judged.summary);
  return {std::move(judged.graph), std::move(refined.cameras)};
}

DrawingGraph DescribeLinks(DrawingGraph graph, const std::vector<View>& views,
                           const std::function<Image(ViewId)>& read_image,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end) {
  if (options.IsPaper()) return graph;
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
  CurvesResult image_curves = ExtractAll(input, options, context, on_stage_end);
  if (input.update) {
    if (auto updated = Update(input, &image_curves, options, context, on_stage_end)) {
      return *std::move(updated);
    }
  }
  auto [sketch, drawing] = DrawExtracted(input, image_curves, options, context, on_stage_end);
  // What follows is done by this process alone.
  RunContext alone = context;
  alone.team = nullptr;

  JudgedDrawing judged =
      RefineAndJudge({{input.views, image_curves.curves, input.hints}, drawing.graph}, options,
                     alone, on_stage_end);
  const std::vector<View>& views = judged.cameras ? judged.cameras->views : input.views;
  DrawingGraph graph = DescribeLinks(std::move(judged.graph), views, input.images.read, options,
                                     alone, on_stage_end);
  if (input.images.release) input.images.release();
  auto keep = RecordWriter(input, image_curves.curves, sketch.plans, graph, options, context);
  return {std::move(image_curves.curves),
          std::move(sketch.sketch),
          std::move(sketch.fates),
          std::move(graph),
          std::move(judged.cameras),
          std::move(drawing.fates),
          std::nullopt,
          std::move(keep)};
}

}  // namespace limn
