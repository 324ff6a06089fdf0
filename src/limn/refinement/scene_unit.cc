// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/scene_unit.h"

#include <cmath>
#include <utility>

#include "limn/model/drawing_transform.h"
#include "limn/model/footprint.h"
#include "limn/util/median.h"

namespace limn {

double SceneUnit(const std::vector<View>& views, const DrawingGraph& graph) {
  std::vector<double> footprints;
  for (const DrawingLink& link : graph.links) {
    const double footprint = LinkFootprint(link, views);
    if (footprint > 0) footprints.push_back(footprint);
  }
  if (footprints.empty()) return 1;
  return std::exp2(std::round(std::log2(Median(std::move(footprints)))) + 10);
}

std::vector<View> Scaled(std::vector<View> views, double factor) {
  for (View& view : views) view.cam_from_world.translation *= factor;
  return views;
}

DrawingGraph Scaled(DrawingGraph graph, double factor) {
  return Transformed(std::move(graph), factor, Eigen::Matrix3d::Identity(),
                     Eigen::Vector3d::Zero());
}

}  // namespace limn
