#pragma once

#include <optional>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/draw_options.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

// What automatic_drawer does with a project: draws its scene, alone or together with the other
// ranks, and writes all results except project.ini. Returns the drawing, relative to the project's
// origin; empty for a shard, and on ranks other than 0. Throws what its stages throw; nothing is
// written before the input has been checked.
std::optional<DrawingGraph> DrawProject(const Project& project, const DrawerOptions& options,
                                        Console* console);

}  // namespace limn::colmap_ext
