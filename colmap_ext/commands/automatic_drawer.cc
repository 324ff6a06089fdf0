#include "colmap_ext/commands/commands.h"
#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/commands/refined_cameras.h"
#include "colmap_ext/commands/results.h"
#include "colmap_ext/commands/run_options.h"
#include "colmap_ext/commands/run_report.h"
#include "colmap_ext/commands/shard_run.h"
#include "limn/pipeline/pipeline.h"
#include "limn/sketch/view_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

int RunAutomaticDrawer(int argc, const char* const* argv) {
  RunOptions options;
  bool account = false;
  bool page = true;
  TruthInput truth;
  const auto parser =
      ParseRunOptions("automatic_drawer", "make the 3D drawing of a COLMAP project",
                      {.linking = true,
                       .sketch = true,
                       .drawing = true,
                       .refinement = true,
                       .shards = true,
                       .writes_drawing = true},
                      argc, argv, &options, [&](OptionParser* more) {
                        more->AddOption("account", &account, "tell what became of every edgel");
                        more->AddOption("page", &page, "write drawing.html, with a report");
                        truth.AddOptions(more);
                      });
  if (!parser) return 0;
  if (account && options.pipeline.mode == SketchMode::kOriginal) {
    throw OptionError("account = 1: the original sketch judges whole curves, not edgels");
  }
  if (truth.IsGiven()) truth.Check();
  truth.evaluation.region = BoxFromNumbers(options.box);
  Console console(options.num_threads);
  const Project project(options, &console);
  if (!options.shard.empty()) {
    DoShard(project, options, ShardStage::kSketches, &console);
    return 0;
  }
  CheckRefinedFolder(project, options);
  CheckReplaceable(project, options, "drawing.json", Provenance(options));
  CheckViews(project.views());
  const PipelineResult result =
      DrawScene({project.views(), project.view_set().hints, project.images(),
                 ProjectBox(project, options), project.cache()},
                options.pipeline, console.context(),
                [&](const StageSummary& summary) { console.Report(summary); });
  CheckGraph(result.graph);
  WriteSketchResults(project, SketchFileName(options.pipeline.mode), result.curves, result.sketch,
                     Provenance(options), console.context());
  WriteRefinedModel(project, result.cameras, &console);
  const std::vector<View>& views = ViewsOfDrawing(project, result.cameras);
  WriteDrawingResults(project, views, result.graph, Provenance(options), &console);
  if (account) WriteAccount(project, result, &console);
  parser->WriteIni(project.CurvesPath("project.ini"));
  if (page) WritePageWithReport(project, options, views, result.graph, truth, &console);
  return 0;
}

}  // namespace limn::colmap_ext
