// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/run_options.h"
#include "limn/pipeline/tiled_scene.h"

namespace limn::colmap_ext {

// Stores the results of the options' shard in the input's cache, with a summary: those of its views
// or, for a scene of several tiles, the drawings of its tiles. Throws what MakeShardCurves,
// MakeShardSketches and MakeShardTiles throw.
void DoShard(const PipelineInput& input, const std::vector<Tile>& tiles, const RunOptions& options,
             Console* console);

// With several ranks: each stores the results of its shard; all of them are in the cache on return.
// The original sketch is not made here. Throws what DoShard throws; if a file cannot be read or
// written, rank 0 throws once all ranks have done what they can.
void FillCacheByRanks(const PipelineInput& input, const std::vector<Tile>& tiles,
                      const PipelineOptions& options, Console* console);

// DrawTiles for a scene with photographs.
DrawingGraph DrawProjectTiles(const PipelineInput& input, const std::vector<Tile>& tiles,
                              const PipelineOptions& options, Console* console);

}  // namespace limn::colmap_ext
