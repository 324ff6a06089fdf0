#include "bench/methods.h"

#include "limn/drawing/drawing.h"
#include "limn/refinement/refinement.h"

namespace limn::bench {
namespace {

Reconstruction AsItIs(const Scene&, const CurveSketch& sketch, const PipelineOptions&,
                      const RunContext&) {
  return {ToCurveSet(sketch), ToSupportedCurves(sketch), std::nullopt, {}};
}

Reconstruction OfDrawing(DrawingGraph graph) {
  return {ToCurveSet(graph), ToSupportedCurves(graph), std::move(graph), {}};
}

Reconstruction Draw(const Scene& scene, const CurveSketch& sketch, const PipelineOptions& options,
                    const RunContext& context) {
  return OfDrawing(
      BuildDrawing({scene.views, scene.curves, sketch}, options.drawing, context).graph);
}

Reconstruction DrawAndRefine(const Scene& scene, const CurveSketch& sketch,
                             const PipelineOptions& options, const RunContext& context) {
  const DrawingGraph drawing =
      BuildDrawing({scene.views, scene.curves, sketch}, options.drawing, context).graph;
  return OfDrawing(RefineDrawing({scene.views, scene.curves, drawing}, options.refinement,
                                 options.drawing.topology, context)
                       .graph);
}

void SetTotalInliers(int inliers, PipelineOptions* options) {
  options->sketch.original_min_inliers_total = inliers;
}

// As in the paper: the same number of views whatever the number that contains a sample.
void SetSupportingViews(int views, PipelineOptions* options) {
  options->sketch.min_supporting_views = views;
  options->drawing.min_supporting_views = options->drawing.max_supporting_views = views;
}

}  // namespace

const std::vector<Method>& Methods() {
  static const std::vector<int> total_inliers = {25, 50, 100, 150, 225, 300};
  static const std::vector<int> views = {3, 4, 5, 6, 7, 8};
  static const std::vector<Method> methods = {
      {"original sketch", SketchMode::kOriginal, AsItIs, "inliers", total_inliers, SetTotalInliers},
      {"enhanced sketch", SketchMode::kEnhanced, AsItIs, "views", views, SetSupportingViews},
      {"enhanced drawing", SketchMode::kEnhanced, Draw, "views", views, SetSupportingViews},
      {"swept sketch", SketchMode::kSweep, AsItIs, "views", views, SetSupportingViews},
      {"swept drawing", SketchMode::kSweep, Draw, "views", views, SetSupportingViews},
      {"refined drawing", SketchMode::kSweep, DrawAndRefine, "views", views, SetSupportingViews},
  };
  return methods;
}

void Workbench::MakeSketch(SketchMode mode, const PipelineOptions& options) {
  PipelineOptions of_sketch;
  of_sketch.mode = mode;
  of_sketch.sketch = options.sketch;
  const std::string text = OptionsAsJson(of_sketch);
  if (text == options_text_) return;
  const Stopwatch stopwatch;
  sketch_ = BuildSketch(mode, {scene_.views, scene_.curves, scene_.hints, std::nullopt},
                        options.sketch, context_)
                .sketch;
  sketch_times_ = stopwatch.Elapsed();
  options_text_ = text;
}

Reconstruction Workbench::Run(const Method& method, const PipelineOptions& options) {
  MakeSketch(method.mode, options);
  const Stopwatch stopwatch;
  Reconstruction reconstruction = method.finish(scene_, sketch_, options, context_);
  reconstruction.times = sketch_times_ + stopwatch.Elapsed();
  return reconstruction;
}

}  // namespace limn::bench
