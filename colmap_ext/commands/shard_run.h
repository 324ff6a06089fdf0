#pragma once

#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/run_options.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

// Keep the results of the views of the options' shard in the input's cache, and say what was done.
// Throws as MakeShardCurves and MakeShardSketches do.
void DoShard(const PipelineInput& input, const RunOptions& options, Console* console);

// With several ranks: each keeps the results of its shard, and all of them are there when this
// returns. The original sketch is left to the run that goes on. Throws as MakeShardCurves and
// MakeShardSketches do.
void FillCacheByRanks(const PipelineInput& input, const PipelineOptions& options, Console* console);

}  // namespace limn::colmap_ext
