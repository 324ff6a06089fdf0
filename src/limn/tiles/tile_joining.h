// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// The drawing of one tile.
struct TileDrawing {
  Eigen::AlignedBox3d core;
  // Covers the tile's reach. Supporting views are ids of the whole scene.
  DrawingGraph graph;
  // Boxes in the core that are cores of other tiles.
  std::vector<Eigen::AlignedBox3d> holes = {};
};

struct JoinedTiles {
  DrawingGraph graph;
  int64_t joined = 0;     // pairs of ends of two tiles that were joined
  int64_t open_ends = 0;  // ends left at a border because the other tile lacks the curve
  int64_t stubs = 0;      // short links with such an end, removed
};

// Joins the drawings of all tiles, whose cores do not overlap except at holes
// (algorithm/tiles.md#joining). Each is cut at the border of its core. Links of two tiles that
// continue each other there become one: both tiles saw the same edgels and drew the same curve to a
// fraction of a px. Links lose their members. Links that are changed lose their primitives. The
// result passes Validate(). Linear in the number of points, per hole.
JoinedTiles JoinTiles(std::vector<TileDrawing> tiles, const std::vector<View>& views);

}  // namespace limn
