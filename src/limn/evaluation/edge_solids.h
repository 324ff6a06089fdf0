// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/wireframe.h"

namespace limn {

// What an edge is thickened to (algorithm/evaluation.md#hss).
enum class EdgeShape {
  kCylinder,  // round, with flat ends
  kHoho2025,  // the prism of six sides that the program of the challenge makes of it
};

// Points p with |normal . p - offset| <= half_width.
struct Slab {
  Eigen::Vector3d normal;
  double offset = 0;
  double half_width = 0;
};

// A convex solid around an edge: what is in all slabs, and, if it is round, within the radius of
// the line through both ends. All of it is within the radius of the edge, seen from anywhere.
struct EdgeSolid {
  Eigen::Vector3d start, end;
  double radius = 0;
  bool is_round = false;
  std::vector<Slab> slabs;
};

// Of the edges longer than 1e-6 of the wireframe's unit, as the program of the challenge skips
// others; those of the same two places once, in the order of coordinates.
std::vector<EdgeSolid> ThickenEdges(const Wireframe& wireframe, EdgeShape shape, double radius);

// The same after a rotation and then a translation.
EdgeSolid Moved(EdgeSolid solid, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& translation);

// The interval of z in which the line of this x and y is inside; nothing if it is not.
std::optional<std::pair<double, double>> ChordAlongZ(const EdgeSolid& solid, double x, double y);

}  // namespace limn
