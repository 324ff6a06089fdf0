// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/pipeline.h"

#include <utility>

#include "limn/belief/tri_angle.h"
#include "limn/cameras/camera_scene.h"
#include "limn/pipeline/update_scene.h"
#include "limn/refinement/fit_other_cameras.h"

namespace limn {

namespace {

std::vector<ImageCurves> ExtractAll(const PipelineInput& input, const PipelineOptions& options,
                                    const RunContext& context, const StageObserver& on_stage_end) {
  options.Check();
  CurvesResult image_curves = ExtractCurves({input.views, input.images, input.cache}, options.edges,
                                            options.linking, context);
  on_stage_end(image_curves.summary);
  return std::move(image_curves.curves);
}

// The input as the refined cameras, if there are any, see it.
PipelineInput SeenBy(const std::optional<RefinedCameras>& cameras, const PipelineInput& given) {
  if (!cameras) return given;
  return {cameras->views, cameras->hints, given.images, given.box, given.cache, given.mounts};
}

DrawnCurves Draw(const PipelineInput& input, const std::vector<ImageCurves>& curves,
                 const PipelineOptions& options, const RunContext& context,
                 const StageObserver& on_stage_end) {
  return DrawCurves({input.views, curves, input.hints, input.box}, options, input.cache, context,
                    on_stage_end);
}

void TakeCameras(const CameraRefiner& refiner, UnrefinedScene* scene) {
  if (refiner.HaveMoved()) scene->cameras = refiner.Cameras();
}

UnrefinedScene DrawRefiningCameras(const PipelineInput& input, std::vector<ImageCurves> curves,
                                   const PipelineOptions& options, const RunContext& context,
                                   const StageObserver& on_stage_end) {
  CameraRefiner refiner({input.views, input.hints, input.images, input.box, *input.mounts},
                        std::move(curves), options, context);
  const auto draw = [&](UnrefinedScene* scene) {
    TakeCameras(refiner, scene);
    scene->drawn =
        Draw(SeenBy(scene->cameras, input), refiner.Curves(), options, context, on_stage_end);
  };
  refiner.RefineBySmallPictures();
  UnrefinedScene scene;
  draw(&scene);
  std::optional<UnrefinedScene> with_given;
  while (refiner.RefineByDrawing(scene.drawn.drawing.graph)) {
    if (!scene.cameras) with_given = std::move(scene);
    scene = {};
    draw(&scene);
  }
  if (scene.cameras && !refiner.HaveMoved()) {
    const bool is_drawn = with_given.has_value();
    scene = is_drawn ? *std::move(with_given) : UnrefinedScene();
    if (!is_drawn) draw(&scene);
  }
  TakeCameras(refiner, &scene);
  scene.rows = refiner.Rows();
  scene.curves = refiner.TakeCurves();
  return scene;
}

UnrefinedScene DrawExtracted(const PipelineInput& input, std::vector<ImageCurves> curves,
                             const PipelineOptions& options, const RunContext& context,
                             const StageObserver& on_stage_end) {
  if (input.mounts && options.refine_cameras != CameraRefinement::kOff) {
    return DrawRefiningCameras(input, std::move(curves), options, context, on_stage_end);
  }
  DrawnCurves drawn = Draw(input, curves, options, context, on_stage_end);
  return {std::move(curves), std::move(drawn), std::nullopt};
}

// A drawing that fits refined cameras, fitted to the given ones instead.
FitToGiven FitGivenCameras(const PipelineInput& given, const CurvesScene& refined,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end, DrawingGraph* graph) {
  FitToGiven fit;
  fit.curves = CurvesThroughOtherLenses(given.views, refined.curves, context);
  OtherCamerasResult result =
      FitOtherCameras({{refined, *graph}, {given.views, fit.curves}}, options.refinement, context);
  on_stage_end(result.summary);
  fit.refined_px = result.before_px;
  fit.given_px = result.after_px;
  // Their kinds are known.
  *graph = DescribeLinks(std::move(result.graph), given.views, {}, options, context, on_stage_end);
  return fit;
}

// If the drawing of an earlier run can be brought up to date; else says why not.
std::optional<PipelineResult> Update(const PipelineInput& input, std::vector<ImageCurves>* curves,
                                     const PipelineOptions& options, const RunContext& context,
                                     const StageObserver& on_stage_end) {
  std::string why_not;
  std::optional<PipelineResult> result =
      UpdateScene(input, curves, options, context, on_stage_end, &why_not);
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
  return DrawExtracted(input, ExtractAll(input, options, context, on_stage_end), options, context,
                       on_stage_end);
}

PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end) {
  std::vector<ImageCurves> extracted = ExtractAll(input, options, context, on_stage_end);
  if (input.update) {
    if (auto updated = Update(input, &extracted, options, context, on_stage_end)) {
      return *std::move(updated);
    }
  }
  auto [curves, drawn, cameras, rows] =
      DrawExtracted(input, std::move(extracted), options, context, on_stage_end);
  const PipelineInput seen = SeenBy(cameras, input);
  // What follows is done by this process alone.
  RunContext alone = context;
  alone.team = nullptr;

  DrawingGraph graph =
      RefineAndJudge({{seen.views, curves}, drawn.drawing.graph}, options, alone, on_stage_end);
  const bool fits_given = cameras && options.output_cameras == OutputCameras::kGiven;
  PipelineOptions described = options;
  if (fits_given) described.regularize = false;  // once it fits them
  graph = DescribeLinks(std::move(graph), seen.views, input.images.read, described, alone,
                        on_stage_end);
  if (cameras && cameras->uncertainty && !fits_given) {
    AddShareOfCameras(*cameras->uncertainty, seen.views, alone, &graph);
    MeasureSigmas(seen.views, alone, &graph);
  }
  if (input.images.release) input.images.release();
  auto keep = RecordWriter(seen, curves, drawn.sketch.plans, graph, options, context);
  std::optional<FitToGiven> fit_to_given;
  if (fits_given) {
    fit_to_given =
        FitGivenCameras(input, {seen.views, curves}, options, alone, on_stage_end, &graph);
  }
  return {std::move(cameras),
          std::move(curves),
          std::move(drawn.sketch.sketch),
          std::move(drawn.sketch.fates),
          std::move(graph),
          std::move(drawn.drawing.fates),
          std::nullopt,
          std::move(rows),
          std::move(fit_to_given),
          std::move(keep)};
}

}  // namespace limn
