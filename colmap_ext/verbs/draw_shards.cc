// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/draw_shards.h"

#include <functional>
#include <string>

#include "colmap_ext/host/ranks.h"
#include "limn/pipeline/shard.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

StageObserver ReportTo(Console* console) {
  return [console](const StageSummary& summary) { console->Report(summary); };
}

TiledInput TiledProject(const PipelineInput& input, const std::vector<Tile>& tiles,
                        const PipelineOptions& options, const Console& console) {
  return {input.views,
          input.hints,
          input.cache,
          tiles,
          CurvesFromImages(input, options, console.context()),
          input.images.read};
}

void MakeTiles(const PipelineInput& input, const std::vector<Tile>& tiles,
               const PipelineOptions& options, const Shard& shard, Console* console) {
  MakeShardTiles(TiledProject(input, tiles, options, *console), options, shard, console->context(),
                 ReportTo(console));
}

// Does a part of the work on every rank. A file that one cannot read or write does not end the
// others before they are done.
void DoOnAllRanks(const std::function<void()>& part) {
  std::string error;
  try {
    part();
  } catch (const IoError& of_file) {
    error = of_file.what();
  }
  MeetAllRanks(error);
}

}  // namespace

void DoShard(const PipelineInput& input, const std::vector<Tile>& tiles, const RunOptions& options,
             Console* console) {
  const Shard shard = ParseShard(options.shard);
  const bool curves_only = options.shard_stage == ShardStage::kCurves;
  const bool in_tiles = !curves_only && IsInTiles(tiles, input.views);
  if (in_tiles) {
    MakeTiles(input, tiles, options.pipeline, shard, console);
  } else {
    const auto make = curves_only ? MakeShardCurves : MakeShardSketches;
    console->Report(make(input, options.pipeline, shard, console->context()));
  }
  const size_t num_items = in_tiles ? tiles.size() : input.views.size();
  console->Say("Shard " + options.shard + " is done, " +
               std::to_string(ItemsOf(shard, num_items).size()) + " of " +
               std::to_string(num_items) + (in_tiles ? " tiles" : " images") +
               ". When all shards are, run the command without --shard");
}

void FillCacheByRanks(const PipelineInput& input, const std::vector<Tile>& tiles,
                      const PipelineOptions& options, Console* console) {
  const Shard shard{Rank() + 1, NumRanks()};
  DoOnAllRanks(
      [&] { console->Report(MakeShardCurves(input, options, shard, console->context())); });
  if (IsInTiles(tiles, input.views)) {
    DoOnAllRanks([&] { MakeTiles(input, tiles, options, shard, console); });
    return;
  }
  if (options.mode == SketchMode::kOriginal) return;
  DoOnAllRanks(
      [&] { console->Report(MakeShardSketches(input, options, shard, console->context())); });
}

DrawingGraph DrawProjectTiles(const PipelineInput& input, const std::vector<Tile>& tiles,
                              const PipelineOptions& options, Console* console) {
  return DrawTiles(TiledProject(input, tiles, options, *console), options, console->context(),
                   ReportTo(console));
}

}  // namespace limn::colmap_ext
