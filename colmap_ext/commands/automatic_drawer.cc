#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/ranks.h"
#include "colmap_ext/run/refined_cameras.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_report.h"
#include "colmap_ext/run/scene_run.h"
#include "colmap_ext/run/shard_run.h"
#include "colmap_ext/run/trust.h"

namespace limn::colmap_ext {

int RunAutomaticDrawer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  // The others begin when rank 0 knows that there is work and holds the lock.
  const bool leads = Rank() == 0;
  if (!leads && !AsRankZero(true)) return 0;
  DrawerOptions options;
  const auto parser = ParseDrawerOptions(argc, argv, &options);
  if (!parser) {
    AsRankZero(false);
    return 0;
  }
  RunOptions& run = options.run;
  run.is_led = !leads;
  const auto console = make_console(run.num_threads, leads);
  const Project project(run, console.get());
  CheckRefinedFolder(project, run);
  CheckDrawingFiles(project, run);
  CheckSketchFiles(project, run);
  CheckReplaceable(project, run, "drawing.json", Provenance(run));
  CheckSceneViews(project);
  const PipelineInput input{project.views(), project.view_set().hints, project.images(),
                            SceneBox(project, run), project.cache()};
  const std::vector<Tile> tiles = PlanSceneTiles(input, options, console.get());
  if (!run.shard.empty()) {
    DoShard(input, tiles, run, console.get());
    return 0;
  }
  const auto result = DrawSceneOrTiles(input, tiles, run.pipeline, console.get());
  if (!result) return 0;
  CheckGraph(result->graph);
  if (!IsInTiles(tiles, input.views)) {
    WriteSketchResults(project, SketchFileName(run.pipeline.mode), result->curves, result->sketch,
                       Provenance(run), console->context());
  }
  WriteRefinedModel(project, result->cameras, console.get());
  const std::vector<View>& views = ViewsOfDrawing(project, result->cameras);
  WriteDrawingResults(project, views, result->graph, Provenance(run), console.get());
  if (options.account) WriteAccount(project, *result, console.get());
  parser->WriteIni(project.CurvesPath("project.ini"));
  const Trust trust = MeasureTrust(views, result->curves, result->graph);
  SayTrust(trust, !run.box.empty(), console.get());
  if (options.page) {
    WritePageWithReport(project, run, views, result->graph, trust, options.truth, console.get());
  }
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
