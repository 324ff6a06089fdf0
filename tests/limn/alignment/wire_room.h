// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/similarity3.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/angles.h"
#include "support/random_numbers.h"

namespace limn::testing {

inline void AddLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world = {from, (from + to) / 2, to};
  link.sigma.assign(3, 0.0005);
  link.primitive = LinkPrimitive{LineSegment{from, to}};
  for (const Eigen::Vector3d& end : {from, to}) {
    DrawingNode node;
    node.position_in_world = end;
    graph->nodes.push_back(node);
  }
  link.node0 = static_cast<NodeId>(graph->nodes.size()) - 2;
  link.node1 = link.node0 + 1;
  graph->links.push_back(link);
}

inline void AddBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high, DrawingGraph* graph) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Vector3d from = low;
      if (corner & 1) from[(axis + 1) % 3] = high[(axis + 1) % 3];
      if (corner & 2) from[(axis + 2) % 3] = high[(axis + 2) % 3];
      Eigen::Vector3d to = from;
      to[axis] = high[axis];
      AddLine(from, to, graph);
    }
  }
}

// A room of 5 x 4 x 2.6 m around the origin with its floor at z = 0, and furniture: z is up, and
// walls are along x and y. Link 0 is 5 m long.
inline DrawingGraph WireRoom() {
  DrawingGraph graph;
  AddBox({-2.5, -2, 0}, {2.5, 2, 2.6}, &graph);
  AddBox({-2.5, -1, 0}, {-2.1, 0.5, 1.9}, &graph);
  AddBox({1, 0.8, 0}, {2.2, 1.6, 0.75}, &graph);
  AddLine({0, -1, 0.4}, {0.6, -0.4, 1.1}, &graph);
  AddLine({0.2, -1, 0.3}, {0.9, -0.7, 0.9}, &graph);
  RebuildIncidence(&graph);
  return graph;
}

inline Eigen::Vector3d RandomDirection(std::mt19937* random) {
  testing::NormalDistribution<double> normal;
  return testing::RandomVector(normal, *random).normalized();
}

// Turned by `angle_rad` about any axis, scaled and moved.
inline Similarity3d RandomSimilarity(double angle_rad, unsigned seed) {
  std::mt19937 random(seed);
  testing::UniformDistribution<double> uniform(-1, 1);
  Similarity3d similarity;
  similarity.rotation = Eigen::AngleAxisd(angle_rad, RandomDirection(&random)).toRotationMatrix();
  similarity.scale = std::exp(uniform(random));
  similarity.translation = 10 * RandomDirection(&random);
  return similarity;
}

inline DrawingGraph Moved(DrawingGraph graph, const Similarity3d& similarity) {
  return Transformed(std::move(graph), similarity.scale, similarity.rotation,
                     similarity.translation);
}

inline double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return Degrees(AngleBetween(a, b));
}

}  // namespace limn::testing
