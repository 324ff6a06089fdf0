// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/formats/svg/svg_drawing_writer.h"

namespace limn {

// A vertex of a flat polyline, and the bulge of the way to the next: the tangent of a quarter of
// the angle of its arc, counter-clockwise positive; 0: straight.
struct ChainVertex {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double bulge = 0;
};

// Links that are drawn as one.
struct FlatChain {
  std::vector<LinkId> links;
  std::vector<ChainVertex> vertices;
  bool closed = false;  // the last vertex leads to the first
};

// Of lines, arcs and links without a shape. Those of one layer are joined where two of them and
// nothing else meet, and lines where they go on within a degree, whatever else ends there; between
// lines the vertex, but the first of a loop, is left out if no end in between is farther than
// `tolerance` from the straight way. Circles, splines, ellipses and rods are in no chain. Linear
// time in links, but in ends at a node quadratic.
std::vector<FlatChain> FindChains(const FlatLinks& flat, const std::vector<int>& layer_of_link,
                                  double tolerance);

}  // namespace limn
