#pragma once

#include <optional>
#include <vector>

#include "colmap_ext/run/console.h"
#include "colmap_ext/run/drawer_options.h"
#include "limn/pipeline/tiled_scene.h"

namespace limn::colmap_ext {

// PlanTiles. What takes all of a scene together is refused where there are several, before work
// starts. Throws OptionError.
std::vector<Tile> PlanSceneTiles(const PipelineInput& input, const DrawerOptions& options,
                                 Console* console);

// Draws the scene in this process, or together with the other ranks: those that only help get
// nothing. Of a scene in tiles there is only the graph. Throws what DrawScene and DrawTiles throw.
std::optional<PipelineResult> DrawSceneOrTiles(const PipelineInput& input,
                                               const std::vector<Tile>& tiles,
                                               const PipelineOptions& options, Console* console);

}  // namespace limn::colmap_ext
