// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/tiles/tile_options.h"

namespace limn {

// A part of space whose curves are drawn together, from the views that see it.
struct Tile {
  Eigen::AlignedBox3d core;   // what the tile contributes; unbounded at the scene's border
  Eigen::AlignedBox3d reach;  // what is drawn: the core and a margin, within the box
  std::vector<ViewId> views;  // ascending
};

// The core of a scene in one tile.
Eigen::AlignedBox3d AllSpace();

// Cuts space by planes across the longest extent of the points in `box` (if there is one), near
// where the views are halved and few points of the sparse model lie, until no tile has more than
// max_views views (algorithm/tiles.md#plan). The cores fill space without overlap. Where more views
// see one place, so that cutting does not help, max_views of them are chosen so that every point is
// seen by many. A view with hardly any of its points in a tile does not belong to it; a tile may
// have no views. Returns one tile with all views if these are few enough or if there are hardly any
// points. Throws OptionError. Time: length of all tracks times log(tiles), and max_views times the
// tracks of tiles whose views are chosen.
std::vector<Tile> PlanTiles(const std::vector<View>& views, const SceneHints& hints,
                            const std::optional<Eigen::AlignedBox3d>& box,
                            const TileOptions& options);

// Returns whether the scene is split into tiles.
bool IsInTiles(const std::vector<Tile>& tiles, const std::vector<View>& views);

}  // namespace limn
