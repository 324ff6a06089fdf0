#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/alignment_run.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/ranks.h"
#include "colmap_ext/run/refined_cameras.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_report.h"
#include "colmap_ext/run/scene_run.h"
#include "colmap_ext/run/shard_run.h"
#include "colmap_ext/run/trust.h"

namespace limn::colmap_ext {

int RunAutomaticDrawer(int argc, const char* const* argv) {
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
  Console console(run.num_threads, leads);
  const Project project(run, &console);
  CheckRunOutputs(project, run);
  CheckProjectViews(project);
  const ProjectAligner aligner(project, run.layout, options.align, &console);
  const PipelineInput input{project.views(), project.view_set().hints, project.images(),
                            ProjectBox(project, run), project.cache()};
  const std::vector<Tile> tiles = PlanSceneTiles(input, options, &console);
  if (!run.shard.empty()) {
    DoShard(input, tiles, run, &console);
    return 0;
  }
  const auto result = DrawSceneOrTiles(input, tiles, run.pipeline, &console);
  if (!result) return 0;
  CheckGraph(result->graph);
  if (!IsInTiles(tiles, input.views)) {
    WriteSketchResults(project, SketchFileName(run.pipeline.mode), result->curves, result->sketch,
                       Provenance(run), console.context());
  }
  WriteRefinedModel(project, result->cameras, &console);
  const std::vector<View>& views = ViewsOfDrawing(project, result->cameras);
  WriteDrawingResults(project, views, result->graph, Provenance(run),
                      aligner.Align(views, result->graph, &console), &console);
  if (options.account) WriteAccount(project, *result, &console);
  parser->WriteIni(project.CurvesPath("project.ini"));
  const Trust trust = MeasureTrust(views, result->curves, result->graph);
  SayTrust(trust, !run.box.empty(), &console);
  if (options.page) {
    WritePageWithReport(project, run, views, result->graph, trust, options.truth, &console);
  }
  console.RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
