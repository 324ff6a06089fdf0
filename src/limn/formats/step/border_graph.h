// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limn {

// The borders of faces as a graph: faces that meet share edges, edges that meet share vertices.
// Only for the writer of STEP files.

// A part of a link between two places where borders of faces begin or end, or a bridge.
struct BorderEdge {
  int link = -1;  // -1: a bridge
  // Positions on the link, ascending.
  double from = 0;
  double to = 0;
  int start = -1;  // vertices
  int end = -1;
  // From the first vertex to the second.
  std::vector<Eigen::Vector3d> course;
  // Faces that are planes and have this edge, ascending.
  std::vector<int> planes;
  // Of a sheet whose curves are the points of links.
  bool of_points = false;

  bool IsBridge() const { return link < 0; }
};

struct BorderStep {
  int edge = -1;
  bool reversed = false;
};

struct BorderSheet {
  int face = -1;
  // Loops of a plane; otherwise the sides of one loop. None is empty.
  std::vector<std::vector<BorderStep>> sides;
};

struct FaceBorders {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<BorderEdge> edges;
  std::vector<BorderSheet> sheets;
};

}  // namespace limn
