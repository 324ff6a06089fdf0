#include "colmap_ext/commands/shard_run.h"

#include <string>

#include "colmap_ext/commands/ranks.h"
#include "limn/pipeline/shard.h"

namespace limn::colmap_ext {

void DoShard(const PipelineInput& input, const RunOptions& options, Console* console) {
  const Shard shard = ParseShard(options.shard);
  const auto make =
      options.shard_stage == ShardStage::kCurves ? MakeShardCurves : MakeShardSketches;
  console->Report(make(input, options.pipeline, shard, console->context()));
  const size_t num_views = input.views.size();
  console->Say("Shard " + options.shard + " is done, " +
               std::to_string(ViewsOf(shard, num_views).size()) + " of " +
               std::to_string(num_views) +
               " images. When all shards are, run the command without --shard");
}

void FillCacheByRanks(const PipelineInput& input, const PipelineOptions& options,
                      Console* console) {
  const Shard shard{Rank() + 1, NumRanks()};
  console->Report(MakeShardCurves(input, options, shard, console->context()));
  WaitForAllRanks();
  if (options.mode == SketchMode::kOriginal) return;
  console->Report(MakeShardSketches(input, options, shard, console->context()));
  WaitForAllRanks();
}

}  // namespace limn::colmap_ext
