#include "colmap_ext/verbs/draw.h"

#include <utility>

#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/draw_scene.h"
#include "colmap_ext/verbs/draw_shards.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/run_report.h"
#include "colmap_ext/verbs/trust.h"

namespace limn::colmap_ext {

std::optional<DrawingGraph> DrawProject(const Project& project, const DrawerOptions& options,
                                        Console* console) {
  const RunOptions& run = options.run;
  CheckRunOutputs(project, run);
  CheckSceneViews(project);
  const SceneAligner aligner(project, run.layout, options.align, console);
  const PipelineInput input{project.views(),        project.view_set().hints, project.images(),
                            SceneBox(project, run), project.cache(),          run.update};
  const std::vector<Tile> tiles = PlanSceneTiles(input, options, console);
  if (!run.shard.empty()) {
    DoShard(input, tiles, run, console);
    return std::nullopt;
  }
  auto result = DrawSceneOrTiles(input, tiles, run.pipeline, console);
  if (!result) return std::nullopt;
  CheckGraph(result->graph);
  if (!IsInTiles(tiles, input.views)) {
    WriteSketchResults(project, SketchFileName(run.pipeline.mode), result->curves, result->sketch,
                       Provenance(run), console->context());
  }
  WriteRefinedModel(project, result->cameras, console);
  const std::vector<View>& views = ViewsOfDrawing(project, result->cameras);
  WriteDrawingResults(project, views, result->graph, Provenance(run),
                      aligner.Align(views, result->graph, console), console, result->new_views);
  if (options.account) WriteAccount(project, *result, console);
  const Trust trust = MeasureTrust(project.view_set(), views, result->curves, result->graph);
  SayTrust(trust, !run.box.empty(), console);
  if (options.page) {
    WritePageWithReport(project, run, views, result->graph, trust, options.truth, console);
  }
  result->keep();
  console->RepeatWarnings();
  return std::move(result->graph);
}

}  // namespace limn::colmap_ext
