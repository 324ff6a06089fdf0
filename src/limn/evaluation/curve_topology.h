// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_set.h"

namespace limn {

// How the polylines of a set are connected: ends that coincide exactly are one node.
struct CurveTopology {
  // Per polyline the nodes of its first and last point; -1 if it has no point.
  std::vector<std::array<int, 2>> end_nodes;
  std::vector<CurveNode> nodes;
};

CurveTopology FindTopology(const std::vector<Polyline3d>& polylines);

// Number of sets of polylines connected through common nodes; polylines without points do not
// count.
int CountComponents(const CurveTopology& topology);

// Nodes with `min_degree` ends or more: the set's own nodes if it has any, else those found.
std::vector<Eigen::Vector3d> NodesOfDegree(const CurveSet& set, int min_degree);

// How many nodes there are of each degree.
std::map<int, int> CountNodesByDegree(const CurveSet& set);

}  // namespace limn
