// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/graph_fixture.h"

namespace limn::testing {

// Points of the x axis at steps of 1, in either direction.
inline Polyline3d Row(int from, int to) {
  Polyline3d points;
  const int step = from < to ? 1 : -1;
  for (int x = from; x != to + step; x += step) points.emplace_back(x, 0, 0);
  return points;
}

inline Polyline3d Reversed(Polyline3d points) {
  std::reverse(points.begin(), points.end());
  return points;
}

// A square with corners 1 apart that begins and ends at the origin.
inline Polyline3d Square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}; }

// Vertices of which each has a sample and an edgel of its own; the last of a loop has none.
inline void GiveVertices(DrawingGraph* graph) {
  for (LinkId id = 0; id < static_cast<LinkId>(graph->links.size()); ++id) {
    DrawingLink& link = graph->links[id];
    for (int k = 0; k < link.size(); ++k) {
      LinkVertex vertex = {(k + 1) * Eigen::Matrix3d::Identity(), 1, k, {}, {}};
      if (!link.closed || k + 1 < link.size()) {
        vertex.support = {{id, k}};
        vertex.samples = {{id, k}};
      }
      link.vertices.push_back(std::move(vertex));
    }
  }
}

// Lines as links with vertices; ends at one place share a node.
inline DrawingGraph GraphWithVertices(const std::vector<Polyline3d>& lines) {
  DrawingGraph graph = GraphOf(lines);
  GiveVertices(&graph);
  return graph;
}

// The samples of a link's points, in order, as their numbers on the curve.
inline std::vector<std::vector<int>> Samples(const DrawingLink& link) {
  std::vector<std::vector<int>> samples;
  for (const LinkVertex& vertex : link.vertices) {
    samples.emplace_back();
    for (const SketchSample& sample : vertex.samples) samples.back().push_back(sample.sample);
  }
  return samples;
}

// What holds after every edit. `graph` may have gaps.
inline void ExpectSound(const DrawingGraph& graph, const std::string& what) {
  DrawingGraph compact = graph;
  GraphEditor(&compact).Compact();
  const std::vector<std::string> broken = Validate(compact);
  ASSERT_TRUE(broken.empty()) << what << ": " << broken.front();
  for (size_t l = 0; l < compact.links.size(); ++l) {
    const DrawingLink& link = compact.links[l];
    ASSERT_EQ(link.sigma.size(), link.points_in_world.size()) << what << ": link " << l;
    ASSERT_EQ(link.vertices.size(), link.points_in_world.size()) << what << ": link " << l;
    const bool alone = link.node0 == link.node1 && compact.nodes[link.node0].Degree() == 2;
    ASSERT_EQ(link.closed, alone) << what << ": link " << l;
    for (const LinkVertex& vertex : link.vertices) {
      ASSERT_TRUE(std::is_sorted(vertex.support.begin(), vertex.support.end())) << what;
    }
  }
  for (const DrawingNode& node : compact.nodes) {
    const bool is_anchor = node.Degree() == 2 && compact.links[node.incident[0].link].closed;
    ASSERT_EQ(node.kind == NodeKind::kLoopAnchor, is_anchor) << what;
    std::set<LinkEnd> continued;
    for (const auto& [a, b] : node.continuations) {
      ASSERT_TRUE(continued.insert(a).second && continued.insert(b).second) << what;
    }
  }
}

}  // namespace limn::testing
