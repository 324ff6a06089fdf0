#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/drawing/drawing.h"
#include "limn/model/curves_scene.h"
#include "limn/pipeline/build_sketch.h"
#include "limn/pipeline/extract_curves.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"

namespace limn {

// The input of a drawing.
struct PipelineInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  const ImageSource& images;
  // Only what lies in this box is reconstructed.
  std::optional<Eigen::AlignedBox3d> box;
  // Image curves and sketches of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  // Instead bring the drawing stored last up to date, if possible (update_scene.h).
  bool update = false;
};

struct PipelineResult {
  std::vector<ImageCurves> curves;
  CurveSketch sketch;
  EdgelFates sketch_fates;
  DrawingGraph graph;
  // The cameras that the drawing fits; only with RefinementOptions::refine_poses.
  std::optional<RefinedCameras> cameras;
  SampleFates sample_fates;
  // Of a drawing that was brought up to date, the views that are new or changed.
  ViewSubset new_views = std::nullopt;
  // Stores the drawing for updates. Call it once all results are written, so that an interrupted
  // run does not count as done.
  std::function<void()> keep = [] {};
};

// Called at the end of every stage.
using StageObserver = std::function<void(const StageSummary& summary)>;

// The drawing of a sketch, by the method of the options. Throws OptionError and Cancelled.
DrawingResult DrawSketch(const DrawingInput& input, const PipelineOptions& options,
                         const RunContext& context);

struct DrawnCurves {
  SketchResult sketch;
  DrawingResult drawing;
};

// Sketch and drawing of the image curves. `cache` and `part` are those of SketchViews. Throws what
// DrawScene throws.
DrawnCurves DrawCurves(const CurvesScene& scene, const PipelineOptions& options, ResultCache* cache,
                       const RunContext& context, const StageObserver& on_stage_end,
                       const std::string& part = "");

struct JudgedDrawing {
  DrawingGraph graph;
  std::optional<RefinedCameras> cameras;
};

// Refines a drawing and judges its links (RefineDrawing, JudgeLinks). The paper's drawing stays as
// it is (PipelineOptions::IsPaper).
JudgedDrawing RefineAndJudge(const RefinementInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end);

// Fits primitives to the links, finds their kinds if images can be read, and makes them regular if
// the options say so (FitPrimitives, ClassifyKinds, Regularize). The paper's drawing stays as it
// is.
DrawingGraph DescribeLinks(DrawingGraph graph, const std::vector<View>& views,
                           const std::function<Image(ViewId)>& read_image,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end);

// The results before the refinement.
struct UnrefinedScene {
  CurvesResult image_curves;
  DrawnCurves drawn;
};

// DrawScene up to the refinement: the part that the processes of the context's team run together,
// each on the whole input. Throws what DrawScene throws.
UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end);

// From photographs to the drawing (ECCV 2016): edges and fragments of every image, sketch, drawing
// graph, refinement, belief, primitives, kinds of edges. Throws OptionError, InputError, what
// `images` throws, and Cancelled.
PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
