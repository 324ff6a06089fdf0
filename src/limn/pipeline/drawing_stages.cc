// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/drawing_stages.h"

#include <utility>

#include "limn/belief/confidence.h"
#include "limn/belief/link_judge.h"
#include "limn/belief/short_curves.h"
#include "limn/belief/tri_angle.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/kinds/smooth_outlines.h"
#include "limn/kinds/texture.h"
#include "limn/paper/paper_drawing.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/regularity/regularize.h"
#include "limn/rods/find_rods.h"

namespace limn {

DrawingResult DrawSketch(const DrawingInput& input, const PipelineOptions& options,
                         const RunContext& context) {
  return options.IsPaper()
             ? BuildPaperDrawing(input, options.paper, options.drawing.topology, context)
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

DrawingGraph RefineAndJudge(const RefinementInput& input, const PipelineOptions& options,
                            const RunContext& context, const StageObserver& on_stage_end) {
  if (options.IsPaper()) return input.graph;
  const DrawingGraph edges = WithoutOutlines(WithoutRods(input.graph));
  RefinementResult refined =
      RefineDrawing({input.scene, edges}, options.refinement, options.drawing.topology, context);
  on_stage_end(refined.summary);
  BeliefResult judged = JudgeLinks({{input.scene.views, input.scene.curves},
                                    refined.graph,
                                    refined.fitted,
                                    options.refinement.Gate()},
                                   options.belief, options.drawing.topology, context);
  on_stage_end(judged.summary);
  if (!options.belief.judge) return std::move(judged.graph);
  RodResult rods = FindRods({input.scene, judged.graph}, context);
  on_stage_end(rods.summary);
  OutlinesResult outlines = FindSmoothOutlines({input.scene, rods.graph}, context);
  on_stage_end(outlines.summary);
  return std::move(outlines.graph);
}

void MeasureLinks(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph) {
  MeasureDepth(views, context, graph);
  TellConfidences(views, graph);
  MeasureCurves(views, graph);
}

DrawingGraph DescribeLinks(DrawingGraph graph, const std::vector<View>& views,
                           const std::function<Image(ViewId)>& read_image,
                           const PipelineOptions& options, const RunContext& context,
                           const StageObserver& on_stage_end) {
  if (options.IsPaper()) return graph;
  BelieveShortCurves(&graph);
  MeasureLinks(views, context, &graph);
  PrimitiveResult primitives = FitPrimitives(graph, views, options.primitives, context);
  on_stage_end(primitives.summary);
  graph = std::move(primitives.graph);
  if (read_image) {
    KindsResult kinds = ClassifyKinds({views, read_image, graph}, context);
    on_stage_end(kinds.summary);
    graph = std::move(kinds.graph);
    on_stage_end(MarkTexture(views, &graph));
  }
  on_stage_end(DoubtShortCurves(views, &graph));
  if (!options.regularize) return graph;
  RegularityResult regular =
      Regularize(graph, views, options.regularity, options.primitives, context);
  on_stage_end(regular.summary);
  return std::move(regular.graph);
}

}  // namespace limn
