// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/dense/sample_sights.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/triangle_mesh.h"
#include "limn/model/drawing_graph.h"
#include "limn/visibility/render_depth.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// A square plate of side 1.2 in the plane z = 0 above a floor, seen from above; pixels are about
// 8 mm large.
constexpr double kPlateHalf = 0.6;
constexpr double kPlatePx = 0.008;

inline const std::vector<View>& PlateViews() {
  static const std::vector<View> views = DomeViews(8, 5);
  return views;
}

inline TriangleMesh PlateMesh() {
  constexpr double h = kPlateHalf;
  constexpr double f = 9;
  constexpr double z = -1.5;
  return MakeTriangleMesh({{-h, -h, 0},
                           {h, -h, 0},
                           {h, h, 0},
                           {-h, h, 0},
                           {-f, -f, z},
                           {f, -f, z},
                           {f, f, z},
                           {-f, f, z}},
                          {{0, 1, 2, 3}, {4, 5, 6, 7}});
}

inline DepthSource PlateDepths() {
  return [](ViewId view) -> std::optional<DepthImage> {
    return RenderDepth(PlateMesh(), PlateViews()[view], 1);
  };
}

// A graph of separate links that all views support.
inline DrawingGraph GraphOf(const std::vector<Polyline3d>& curves) {
  DrawingGraph graph;
  for (const Polyline3d& points : curves) {
    DrawingLink link;
    link.points_in_world = points;
    link.sigma.assign(points.size(), kPlatePx);
    for (const Eigen::Vector3d& end : {points.front(), points.back()}) {
      graph.nodes.emplace_back();
      graph.nodes.back().position_in_world = end;
    }
    link.node0 = static_cast<NodeId>(graph.nodes.size()) - 2;
    link.node1 = link.node0 + 1;
    for (size_t v = 0; v < PlateViews().size(); ++v) {
      link.supporting_views.push_back(static_cast<ViewId>(v));
    }
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  return graph;
}

}  // namespace limn::testing
