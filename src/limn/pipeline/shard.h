#pragma once

#include <string>
#include <vector>

#include "limn/pipeline/pipeline.h"

namespace limn {

// Part `index` (from 1) of `count` parts of the views or tiles of a scene: as many each, but for
// one, that follow one another, so that most of the views which a part looks at are its own.
struct Shard {
  int index = 1;
  int count = 1;
};

// Of a text such as "2/8". Throws OptionError.
Shard ParseShard(const std::string& text);

// The views or tiles of a shard, ascending; none if there are fewer of them than shards.
std::vector<ViewId> ItemsOf(const Shard& shard, size_t num_items);

// What processes that know nothing of each other do of DrawScene, which then finds the results of
// all shards in the cache. A process that ends early has kept what it finished, and whatever is
// missing in the end is made by DrawScene.

// Keep the image curves of the views of a shard. Throws IoError if one could not be kept.
StageSummary MakeShardCurves(const PipelineInput& input, const PipelineOptions& options,
                             const Shard& shard, const RunContext& context);

// Keep the sketches of the views of a shard. Only the image curves of the views that these are
// compared with are read, and made and kept where they are missing. Throws IoError if a sketch
// could not be kept, and OptionError if the mode of the sketch is the original one, which is not
// made view by view.
StageSummary MakeShardSketches(const PipelineInput& input, const PipelineOptions& options,
                               const Shard& shard, const RunContext& context);

// Throws IoError if a result of this kind could not be kept.
void CheckKept(const ResultCache& cache, CachedKind kind);

}  // namespace limn
