#pragma once

#include <functional>
#include <vector>

#include "limn/model/scene_subset.h"
#include "limn/pipeline/pipeline.h"
#include "limn/pipeline/shard.h"
#include "limn/tiles/tile_plan.h"

namespace limn {

// A scene that is drawn tile by tile, so that no more than one of them is in memory.
struct TiledInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  // Sketches and drawings of tiles of earlier runs; what is made is kept there. Never null.
  ResultCache* cache;
  const std::vector<Tile>& tiles;  // of PlanTiles
  // Makes the image curves of some views, or gets them from where they are kept.
  std::function<CurvesResult(const SceneSubset&)> curves_of;
};

// The image curves of some views of a scene with photographs, by way of its cache.
std::function<CurvesResult(const SceneSubset&)> CurvesFromImages(const PipelineInput& input,
                                                                 const PipelineOptions& options,
                                                                 const RunContext& context);

// Throws OptionError for options that ask for what tiles cannot do: poses are refined with all
// views together.
void CheckTiled(const PipelineOptions& options);

// Like DrawScene, but every tile is drawn for itself, up to the refinement, and then the tiles are
// joined (JoinTiles) and the primitives fitted. Throws what DrawScene and CheckTiled throw.
DrawingGraph DrawTiles(const TiledInput& input, const PipelineOptions& options,
                       const RunContext& context, const StageObserver& on_stage_end);

// Keep the drawings of the tiles of a shard. Throws IoError if one could not be kept, and what
// DrawTiles throws.
void MakeShardTiles(const TiledInput& input, const PipelineOptions& options, const Shard& shard,
                    const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
