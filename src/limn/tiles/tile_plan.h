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
  Eigen::AlignedBox3d core;   // what the tile gives to the drawing; infinite at the scene's border
  Eigen::AlignedBox3d reach;  // core and margin, inside the box: what is drawn
  std::vector<ViewId> views;  // ascending
};

// Cut space in planes across the longest extent of what lies in `box` (if there is one), near where
// the views are halved and few of the sparse model's points lie, until no tile has more than
// max_views views. The cores fill space without overlap. A place that more views see, and that
// cutting does not help, is drawn from max_views of them, chosen so that every point is seen by
// many. A view that has hardly any of its points in a tile is not of the tile; a tile may be left
// without views. One tile with all views if these are few enough, or if there are hardly any points
// to cut by. Throws OptionError. Time: length of all tracks times log(tiles), and max_views times
// the tracks of tiles whose views are chosen.
std::vector<Tile> PlanTiles(const std::vector<View>& views, const SceneHints& hints,
                            const std::optional<Eigen::AlignedBox3d>& box,
                            const TileOptions& options);

// Is this more than the whole scene at once?
bool IsInTiles(const std::vector<Tile>& tiles, const std::vector<View>& views);

}  // namespace limn
