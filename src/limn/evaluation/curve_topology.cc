// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/curve_topology.h"

#include <set>
#include <tuple>

#include "limn/util/union_find.h"

namespace limn {

CurveTopology FindTopology(const std::vector<Polyline3d>& polylines) {
  CurveTopology topology;
  std::map<std::tuple<double, double, double>, int> node_at;
  const auto add_end = [&](const Eigen::Vector3d& position) {
    const auto [place, is_new] = node_at.try_emplace({position.x(), position.y(), position.z()},
                                                     static_cast<int>(topology.nodes.size()));
    if (is_new) topology.nodes.push_back({position, 0});
    ++topology.nodes[place->second].degree;
    return place->second;
  };
  for (const Polyline3d& polyline : polylines) {
    if (polyline.empty()) {
      topology.end_nodes.push_back({-1, -1});
    } else {
      const int first = add_end(polyline.front());
      topology.end_nodes.push_back({first, add_end(polyline.back())});
    }
  }
  return topology;
}

int CountComponents(const CurveTopology& topology) {
  UnionFind sets(static_cast<int>(topology.nodes.size()));
  for (const auto& [first, last] : topology.end_nodes) {
    if (first >= 0) sets.Union(first, last);
  }
  std::set<int> components;
  for (size_t node = 0; node < topology.nodes.size(); ++node) {
    components.insert(sets.Find(static_cast<int>(node)));
  }
  return static_cast<int>(components.size());
}

std::vector<Eigen::Vector3d> NodesOfDegree(const CurveSet& set, int min_degree) {
  const std::vector<CurveNode> nodes =
      set.nodes.empty() ? FindTopology(set.polylines).nodes : set.nodes;
  std::vector<Eigen::Vector3d> positions;
  for (const CurveNode& node : nodes) {
    if (node.degree >= min_degree) positions.push_back(node.position_in_world);
  }
  return positions;
}

std::map<int, int> CountNodesByDegree(const CurveSet& set) {
  const std::vector<CurveNode> nodes =
      set.nodes.empty() ? FindTopology(set.polylines).nodes : set.nodes;
  std::map<int, int> counts;
  for (const CurveNode& node : nodes) ++counts[node.degree];
  return counts;
}

}  // namespace limn
