#pragma once

#include <vector>

#include "colmap_ext/run/console.h"
#include "colmap_ext/run/run_options.h"
#include "limn/pipeline/tiled_scene.h"

namespace limn::colmap_ext {

// Keep the results of the views of the options' shard in the input's cache, and say what was done:
// of a scene of more than one tile, the drawings of its tiles. Throws as MakeShardCurves,
// MakeShardSketches and MakeShardTiles do.
void DoShard(const PipelineInput& input, const std::vector<Tile>& tiles, const RunOptions& options,
             Console* console);

// With several ranks: each keeps the results of its shard, and all of them are there when this
// returns. The original sketch is left to the run that goes on. Throws as DoShard does.
void FillCacheByRanks(const PipelineInput& input, const std::vector<Tile>& tiles,
                      const PipelineOptions& options, Console* console);

// DrawTiles of a scene with photographs.
DrawingGraph DrawProjectTiles(const PipelineInput& input, const std::vector<Tile>& tiles,
                              const PipelineOptions& options, Console* console);

}  // namespace limn::colmap_ext
