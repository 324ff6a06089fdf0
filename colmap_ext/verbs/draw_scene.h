#pragma once

#include <optional>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/verbs/draw_options.h"
#include "limn/pipeline/tiled_scene.h"

namespace limn::colmap_ext {

// PlanTiles. Throws OptionError, before work starts, if there are several tiles and an option needs
// the whole scene at once.
std::vector<Tile> PlanSceneTiles(const PipelineInput& input, const DrawerOptions& options,
                                 Console* console);

// Draws the scene in this process, or together with the other ranks; only rank 0 gets a result. For
// a scene in tiles it has only the graph. Throws what DrawScene and DrawTiles throw.
std::optional<PipelineResult> DrawSceneOrTiles(const PipelineInput& input,
                                               const std::vector<Tile>& tiles,
                                               const PipelineOptions& options, Console* console);

}  // namespace limn::colmap_ext
