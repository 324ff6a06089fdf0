#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/ranks.h"
#include "colmap_ext/run/refined_cameras.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/run/run_report.h"
#include "colmap_ext/run/shard_run.h"
#include "limn/pipeline/pipeline.h"
#include "limn/sketch/view_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace {

// By this process, or together with the other ranks: those that only help get nothing. Of a scene
// in tiles there is only the graph.
std::optional<PipelineResult> Draw(const PipelineInput& input, const std::vector<Tile>& tiles,
                                   const PipelineOptions& options, Console* console) {
  const auto report = [&](const StageSummary& summary) { console->Report(summary); };
  const bool leads = Rank() == 0;
  if (NumRanks() > 1) {
    if (leads) AsRankZero(true);
    FillCacheByRanks(input, tiles, options, console);
  }
  if (IsInTiles(tiles, input.views)) {
    if (!leads) return std::nullopt;
    PipelineResult result;
    result.graph = DrawProjectTiles(input, tiles, options, console);
    return result;
  }
  if (NumRanks() == 1) return DrawScene(input, options, console->context(), report);
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

// What takes all of a scene together is refused before work starts.
void PrepareTiles(size_t num_tiles, const PipelineOptions& options, bool account,
                  Console* console) {
  CheckTiled(options);
  const std::string in_tiles = "the scene is drawn in " + std::to_string(num_tiles) + " tiles";
  if (account) throw OptionError("account = 1: " + in_tiles + ", which keep no account");
  console->Say("Views are many: " + in_tiles + ", and there will be no file of its sketch");
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
                       .tiles = true,
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
  const std::vector<Tile> tiles =
      PlanTiles(input.views, input.hints, input.box, options.pipeline.tiles);
  const bool in_tiles = IsInTiles(tiles, input.views);
  if (in_tiles) PrepareTiles(tiles.size(), options.pipeline, account, &console);
  if (!options.shard.empty()) {
    DoShard(input, tiles, options, &console);
    return 0;
  }
  const std::optional<PipelineResult> drawn = Draw(input, tiles, options.pipeline, &console);
  if (!drawn) return 0;
  const PipelineResult& result = *drawn;
  CheckGraph(result.graph);
  if (!in_tiles) {
    WriteSketchResults(project, SketchFileName(options.pipeline.mode), result.curves, result.sketch,
                       Provenance(options), console.context());
  }
  WriteRefinedModel(project, result.cameras, &console);
  const std::vector<View>& views = ViewsOfDrawing(project, result.cameras);
  WriteDrawingResults(project, views, result.graph, Provenance(options), &console);
  if (account) WriteAccount(project, result, &console);
  parser->WriteIni(project.CurvesPath("project.ini"));
  if (page) WritePageWithReport(project, options, views, result.graph, truth, &console);
  return 0;
}

}  // namespace limn::colmap_ext
