#include "limn/pipeline/pipeline.h"

#include <utility>

#include "limn/pipeline/refine_cameras.h"
#include "limn/pipeline/update_scene.h"

namespace limn {

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

  if (input.checked_mounts && CamerasAreOff(drawing.graph, input.views, image_curves.curves,
                                            input.hints, *input.checked_mounts, options, alone)) {
    PipelineResult unfinished;
    unfinished.cameras_are_off = true;
    return unfinished;
  }
  DrawingGraph graph = RefineAndJudge({{input.views, image_curves.curves}, drawing.graph}, options,
                                      alone, on_stage_end);
  graph =
      DescribeLinks(std::move(graph), input.views, input.images.read, options, alone, on_stage_end);
  if (input.images.release) input.images.release();
  auto keep = RecordWriter(input, image_curves.curves, sketch.plans, graph, options, context);
  return {false,
          std::move(image_curves.curves),
          std::move(sketch.sketch),
          std::move(sketch.fates),
          std::move(graph),
          std::move(drawing.fates),
          std::nullopt,
          std::move(keep)};
}

}  // namespace limn
