// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "limn/model/scene_subset.h"
#include "limn/pipeline/pipeline.h"
#include "limn/pipeline/shard.h"
#include "limn/tiles/tile_plan.h"

namespace limn {

// A scene that is drawn tile by tile, with only one tile in memory.
struct TiledInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  // Sketches and drawings of tiles of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  const std::vector<Tile>& tiles;  // of PlanTiles
  // Makes or loads the image curves of some views.
  std::function<CurvesResult(const SceneSubset&)> curves_of;
  // Reads a photograph, for the kinds of edges.
  std::function<Image(ViewId)> read_image;
};

// The image curves of some views of a scene with photographs, using its cache.
std::function<CurvesResult(const SceneSubset&)> CurvesFromImages(const PipelineInput& input,
                                                                 const PipelineOptions& options,
                                                                 const RunContext& context);

// Like DrawScene, but every tile is drawn and refined separately; then the tiles are joined
// (JoinTiles), primitives are fitted and kinds of edges found. Throws what DrawScene throws.
DrawingGraph DrawTiles(const TiledInput& input, const PipelineOptions& options,
                       const RunContext& context, const StageObserver& on_stage_end);

// Makes and stores the drawings of the tiles of a shard. Throws IoError if one could not be stored,
// and what DrawTiles throws.
void MakeShardTiles(const TiledInput& input, const PipelineOptions& options, const Shard& shard,
                    const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
