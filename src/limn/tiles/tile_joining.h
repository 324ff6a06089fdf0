#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// What was drawn of a tile.
struct TileDrawing {
  Eigen::AlignedBox3d core;
  // Of the tile's reach; its supporting views are ids in the whole scene.
  DrawingGraph graph;
};

struct JoinedTiles {
  DrawingGraph graph;
  int64_t joined = 0;     // pairs of ends of two tiles that became one
  int64_t open_ends = 0;  // ends at a border, because the other tile does not have the curve
  int64_t stubs = 0;      // links removed because they have such an end and are short
};

// One drawing of all tiles, whose cores do not overlap. Each is cut at its border, and where a link
// of another goes on at the same place in the same direction the two become one: both tiles saw the
// same edgels there, and drew the same curve to a fraction of a px. Links lose their members. The
// result passes Validate(). Time: linear in the number of points.
JoinedTiles JoinTiles(std::vector<TileDrawing> tiles, const std::vector<View>& views);

}  // namespace limn
