#include "colmap_ext/verbs/draw_scene.h"

#include <string>

#include "colmap_ext/host/ranks.h"
#include "colmap_ext/verbs/draw_shards.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// By all ranks together.
std::optional<PipelineResult> DrawSceneByRanks(const PipelineInput& input,
                                               const PipelineOptions& options, Console* console) {
  const auto report = [&](const StageSummary& summary) { console->Report(summary); };
  RankTeam team;
  RunContext context = console->context();
  context.team = &team;
  if (Rank() != 0) {
    DrawUnrefined(input, options, context, report);
    return std::nullopt;
  }
  PipelineResult result = DrawScene(input, options, context, report);
  console->Say("For the drawing the processes sent each other " +
               std::to_string(team.bytes_exchanged() >> 20) + " MB");
  return result;
}

}  // namespace

std::vector<Tile> PlanSceneTiles(const PipelineInput& input, const DrawerOptions& options,
                                 Console* console) {
  const PipelineOptions& pipeline = options.run.pipeline;
  std::vector<Tile> tiles = PlanTiles(input.views, input.hints, input.box, pipeline.tiles);
  if (!IsInTiles(tiles, input.views)) return tiles;
  CheckTiled(pipeline);
  const std::string in_tiles = "the scene is drawn in " + std::to_string(tiles.size()) + " tiles";
  if (options.account) throw OptionError("account = 1: " + in_tiles + ", which keep no account");
  console->Say("Views are many: " + in_tiles + ", and there will be no file of its sketch");
  return tiles;
}

std::optional<PipelineResult> DrawSceneOrTiles(const PipelineInput& input,
                                               const std::vector<Tile>& tiles,
                                               const PipelineOptions& options, Console* console) {
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
  if (NumRanks() > 1) return DrawSceneByRanks(input, options, console);
  return DrawScene(input, options, console->context(),
                   [&](const StageSummary& summary) { console->Report(summary); });
}

}  // namespace limn::colmap_ext
