// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cache/result_cache.h"
#include "limn/drawing/drawing.h"
#include "limn/model/curves_scene.h"
#include "limn/model/image.h"
#include "limn/pipeline/build_sketch.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"

namespace limn {

// The stages after the image curves, for scenes, their tiles and updates.

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

// Refines a drawing, judges its links and finds rods and outlines of smooth bodies (RefineDrawing,
// JudgeLinks, FindRods, FindSmoothOutlines; the last two only among judged links). The paper's
// drawing stays as it is (PipelineOptions::IsPaper).
DrawingGraph RefineAndJudge(const RefinementInput& input, const PipelineOptions& options,
                            const RunContext& context, const StageObserver& on_stage_end);

// Tells angles, standard deviations of the depth, confidences and lengths of curves of all links
// (MeasureDepth, TellConfidences, MeasureCurves).
void MeasureLinks(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph);

// Measures the links, fits primitives to them, finds their kinds and texture
// if images can be read, doubts short unlikely ones, and makes them regular if the options say so
// (FitPrimitives, ClassifyKinds, MarkTexture, DoubtShortCurves, Regularize). The paper's drawing
// stays as it is.
DrawingGraph DescribeLinks(DrawingGraph graph, const std::vector<View>& views,
                           const std::function<Image(ViewId)>& read_image,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end);

}  // namespace limn
