#pragma once

#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/commands/run_options.h"

namespace limn::colmap_ext {

// Keep the results of the views of the options' shard in the project's cache, and say what was
// done. Throws as MakeShardCurves and MakeShardSketches do.
void DoShard(const Project& project, const RunOptions& options, Console* console);

}  // namespace limn::colmap_ext
