#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/drawing/drawing.h"
#include "limn/pipeline/extract_curves.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"
#include "limn/sketch/sketch.h"

namespace limn {

// Everything a drawing is made from.
struct PipelineInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  const ImageSource& images;
  // Only what lies in this box is reconstructed.
  std::optional<Eigen::AlignedBox3d> box;
  // Image curves and sketches of earlier runs; what is made is kept there. Never null.
  ResultCache* cache;
};

struct PipelineResult {
  std::vector<ImageCurves> curves;
  CurveSketch sketch;
  EdgelFates sketch_fates;
  DrawingGraph graph;
  // Only with RefinementOptions::refine_poses: what the drawing fits.
  std::optional<RefinedCameras> cameras;
  SampleFates sample_fates;
};

// Hears of every stage when it has ended.
using StageObserver = std::function<void(const StageSummary& summary)>;

// A scene whose image curves are there.
struct CurvesScene {
  const std::vector<View>& views;
  const SceneHints& hints;
  const std::vector<ImageCurves>& curves;  // per view
  std::optional<Eigen::AlignedBox3d> box;
  ResultCache* cache;
  std::string part = "";  // see SketchViews
};

struct DrawnCurves {
  SketchResult sketch;
  DrawingResult drawing;
};

// Sketch and drawing of the image curves. What DrawScene throws.
DrawnCurves DrawCurves(const CurvesScene& scene, const PipelineOptions& options,
                       const RunContext& context, const StageObserver& on_stage_end);

// What comes before the refinement.
struct UnrefinedScene {
  CurvesResult image_curves;
  DrawnCurves drawn;
};

// DrawScene up to the refinement: what the processes of the context's team do together, each of
// them on all of the input. What it throws, too.
UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end);

// The whole way from photographs to the drawing (ECCV 2016): edges and fragments of every image,
// the sketch, the drawing graph, its refinement, its primitives. Throws OptionError, InputError,
// what `images` throws, and Cancelled.
PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
