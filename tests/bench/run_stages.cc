// SPDX-License-Identifier: BSD-3-Clause
#include "bench/run_stages.h"

#include <utility>

#include "limn/model/link_selection.h"
#include "limn/pipeline/drawing_stages.h"

namespace limn::bench {
namespace {

// With tentative links: which these are is known only at the end.
CurveSet AsSeen(const DrawingGraph& graph) {
  LinkSelection selection = LinkSelection::AsSeen();
  selection.kinds.fill(true);
  selection.tentative = true;
  return ToCurveSet(Selected(graph, selection));
}

}  // namespace

void RunStages(const Scene& scene, const std::function<Image(ViewId)>& read_image,
               const PipelineOptions& options, const RunContext& context,
               const StageListener& listener) {
  StageMeter meter;
  std::string last;
  const auto on_stage_end = [&](const StageSummary& summary) {
    last = summary.stage;
    listener.on_stage_end(meter.Finish(last));
    meter = StageMeter();
  };
  const auto on_made = [&](const std::string& stage, CurveSet made) {
    listener.on_made(stage, made);
    made = {};
    meter = StageMeter();
  };
  ResultCache no_cache{""};
  const CurvesScene curves{scene.views, scene.curves, scene.hints};
  const DrawnCurves drawn = DrawCurves(curves, options, &no_cache, context, on_stage_end);
  on_made(drawn.sketch.summary.stage, ToCurveSet(drawn.sketch.sketch));
  on_made(drawn.drawing.summary.stage, ToCurveSet(drawn.drawing.graph));
  DrawingGraph graph =
      RefineAndJudge({curves, drawn.drawing.graph}, options, context, on_stage_end);
  on_made(last, AsSeen(graph));
  graph = DescribeLinks(std::move(graph), scene.views, read_image, options, context, on_stage_end);
  on_made(last, AsSeen(graph));
}

}  // namespace limn::bench
