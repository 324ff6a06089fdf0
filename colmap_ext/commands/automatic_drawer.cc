#include <optional>
#include <string>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/commands/ranks.h"
#include "colmap_ext/commands/refined_cameras.h"
#include "colmap_ext/commands/results.h"
#include "colmap_ext/commands/run_options.h"
#include "colmap_ext/commands/run_report.h"
#include "colmap_ext/commands/shard_run.h"
#include "limn/pipeline/pipeline.h"
#include "limn/sketch/view_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace {

// By this process, or together with the other ranks: those that only help get nothing.
std::optional<PipelineResult> Draw(const PipelineInput& input, const PipelineOptions& options,
                                   Console* console) {
  const auto report = [&](const StageSummary& summary) { console->Report(summary); };
  if (NumRanks() == 1) return DrawScene(input, options, console->context(), report);
  const bool leads = Rank() == 0;
  if (leads) AsRankZero(true);
  FillCacheByRanks(input, options, console);
  RankTeam team;
  RunContext context = console->context();
  context.team = &team;
  if (!leads) {
    DrawUnrefined(input, options, context, report);
    return std::nullopt;
  }
  PipelineResult result = DrawScene(input, options, context, report);
  console->Say("For the drawing the processes sent each other " +
               std::to_string(team.bytes_exchanged() >> 20) + " MB");
  return result;
}

}  // namespace

int RunAutomaticDrawer(int argc, const char* const* argv) {
  // The others begin when rank 0 knows that there is work and holds the lock.
  const bool leads = Rank() == 0;
  if (!leads && !AsRankZero(true)) return 0;
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
  if (!parser) {
    AsRankZero(false);
    return 0;
  }
  options.is_led = !leads;
  if (!options.shard.empty() && NumRanks() > 1) {
    throw OptionError("shard = " + options.shard + ": MPI processes make their own shards");
  }
  if (account && options.pipeline.mode == SketchMode::kOriginal) {
    throw OptionError("account = 1: the original sketch judges whole curves, not edgels");
  }
  if (truth.IsGiven()) truth.Check();
  truth.evaluation.region = BoxFromNumbers(options.box);
  Console console(options.num_threads, leads);
  const Project project(options, &console);
  CheckRefinedFolder(project, options);
  CheckReplaceable(project, options, "drawing.json", Provenance(options));
  CheckViews(project.views());
  const PipelineInput input{project.views(), project.view_set().hints, project.images(),
                            ProjectBox(project, options), project.cache()};
  if (!options.shard.empty()) {
    DoShard(input, options, &console);
    return 0;
  }
  const std::optional<PipelineResult> drawn = Draw(input, options.pipeline, &console);
  if (!drawn) return 0;
  const PipelineResult& result = *drawn;
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
