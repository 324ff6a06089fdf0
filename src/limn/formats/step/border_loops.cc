// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/border_loops.h"

#include <algorithm>
#include <functional>

#include "limn/geometry/polygon_triangulation.h"

namespace limn {
namespace {

int StartOfStep(const std::vector<BorderEdge>& edges, const BorderStep& step) {
  return step.reversed ? edges[step.edge].end : edges[step.edge].start;
}
int EndOfStep(const std::vector<BorderEdge>& edges, const BorderStep& step) {
  return step.reversed ? edges[step.edge].start : edges[step.edge].end;
}

double AreaWithin(const std::vector<BorderEdge>& edges, const std::vector<BorderStep>& loop) {
  std::vector<Eigen::Vector3d> points;
  for (const BorderStep& step : loop) {
    std::vector<Eigen::Vector3d> course = edges[step.edge].course;
    if (step.reversed) std::reverse(course.begin(), course.end());
    points.insert(points.end(), course.begin(), course.end());
  }
  return PolygonAreaVector(points).norm();
}

}  // namespace

std::vector<std::vector<BorderStep>> SimpleLoops(const std::vector<BorderEdge>& edges,
                                                 const std::vector<BorderStep>& steps) {
  std::vector<std::vector<BorderStep>> loops;
  std::vector<BorderStep> way;
  for (const BorderStep& step : steps) {
    way.push_back(step);
    const auto begin =
        std::ranges::find(way, EndOfStep(edges, step),
                          [&](const BorderStep& before) { return StartOfStep(edges, before); });
    if (begin == way.end()) continue;
    loops.emplace_back(begin, way.end());
    way.erase(begin, way.end());
  }
  std::ranges::stable_sort(loops, std::greater<>(),
                           [&](const auto& loop) { return AreaWithin(edges, loop); });
  return loops;
}

}  // namespace limn
