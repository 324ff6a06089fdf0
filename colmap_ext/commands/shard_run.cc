#include "colmap_ext/commands/shard_run.h"

#include "limn/pipeline/shard.h"

namespace limn::colmap_ext {

void DoShard(const Project& project, const RunOptions& options, Console* console) {
  const Shard shard = ParseShard(options.shard);
  const PipelineInput input{project.views(), project.view_set().hints, project.images(),
                            ProjectBox(project, options), project.cache()};
  const auto make =
      options.shard_stage == ShardStage::kCurves ? MakeShardCurves : MakeShardSketches;
  console->Report(make(input, options.pipeline, shard, console->context()));
  const size_t num_views = project.views().size();
  console->Say("Shard " + options.shard + " is done, " +
               std::to_string(ViewsOf(shard, num_views).size()) + " of " +
               std::to_string(num_views) +
               " images. When all shards are, run the command without --shard");
}

}  // namespace limn::colmap_ext
