// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/pipeline/pipeline.h"

namespace limn {

// Part `index` (from 1) of `count` parts of the views or tiles of a scene. Parts are consecutive
// and differ by at most one in size, so that most of the views that a part needs are its own.
struct Shard {
  int index = 1;
  int count = 1;
};

// Parses a text such as "2/8". Throws OptionError.
Shard ParseShard(const std::string& text);

// The views or tiles of a shard, ascending; none if there are fewer of them than shards.
std::vector<ViewId> ItemsOf(const Shard& shard, size_t num_items);

// The parts of DrawScene that independent processes can do; DrawScene then finds the results of all
// shards in the cache. A process that ends early has stored what it finished, and DrawScene makes
// what is missing.

// Makes and stores the image curves of the views of a shard. Throws IoError if one could not be
// stored.
StageSummary MakeShardCurves(const PipelineInput& input, const PipelineOptions& options,
                             const Shard& shard, const RunContext& context);

// Makes and stores the sketches of the views of a shard. Reads only the image curves of these and
// of the views that they are matched with; missing ones are made and stored. Throws IoError if a
// sketch could not be stored, and OptionError for the original sketch, which is not made view by
// view.
StageSummary MakeShardSketches(const PipelineInput& input, const PipelineOptions& options,
                               const Shard& shard, const RunContext& context);

// Throws IoError if a result of this kind could not be stored.
void CheckKept(const ResultCache& cache, CachedKind kind);

}  // namespace limn
