// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/shard.h"

#include <numeric>
#include <string_view>

#include "limn/pipeline/sketch_views.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

StageSummary OfShard(StageSummary summary, const Shard& shard) {
  summary.stage += ", shard " + std::to_string(shard.index) + "/" + std::to_string(shard.count);
  return summary;
}

}  // namespace

Shard ParseShard(const std::string& text) {
  const std::string_view all = text;
  const size_t slash = all.find('/');
  const auto index = ParseNumber<int>(all.substr(0, slash));
  const auto count = ParseNumber<int>(slash == all.npos ? "" : all.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count) {
    throw OptionError("shard = " + text + ": must be i/n with 1 <= i <= n");
  }
  return {*index, *count};
}

std::vector<ViewId> ItemsOf(const Shard& shard, size_t num_items) {
  const auto begin_of = [&](int index) {
    return static_cast<ViewId>(num_items * static_cast<size_t>(index - 1) / shard.count);
  };
  std::vector<ViewId> items(begin_of(shard.index + 1) - begin_of(shard.index));
  std::iota(items.begin(), items.end(), begin_of(shard.index));
  return items;
}

void CheckKept(const ResultCache& cache, CachedKind kind) {
  const CacheUse use = cache.Use(kind);
  if (use.not_stored > 0) throw IoError(cache.dir(), "cannot keep results: " + use.write_error);
}

StageSummary MakeShardCurves(const PipelineInput& input, const PipelineOptions& options,
                             const Shard& shard, const RunContext& context) {
  options.Check();
  const CurvesResult result =
      ExtractCurves({input.views, input.images, input.cache, ItemsOf(shard, input.views.size())},
                    options.edges, options.linking, context);
  CheckKept(*input.cache, CachedKind::kFragments);
  return OfShard(result.summary, shard);
}

StageSummary MakeShardSketches(const PipelineInput& input, const PipelineOptions& options,
                               const Shard& shard, const RunContext& context) {
  options.Check();
  if (options.mode == SketchMode::kOriginal) {
    throw OptionError("mode = " + std::string(SketchModeName(options.mode)) +
                      ": this sketch is not made view by view, and has no shards");
  }
  const std::vector<ViewId> views = ItemsOf(shard, input.views.size());
  const auto plans = SelectViews(input.views, input.hints, options.sketch.view_selection, context);
  const CurvesResult image_curves =
      ExtractCurves({input.views, input.images, input.cache, WithPartners(views, plans)},
                    options.edges, options.linking, context);
  const SketchResult sketch =
      SketchViews(options.mode, {{input.views, image_curves.curves, input.hints, input.box}, views},
                  options.sketch, input.cache, context);
  CheckKept(*input.cache, CachedKind::kSketch);
  return OfShard(sketch.summary, shard);
}

}  // namespace limn
