// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/continuity.h"

#include <cmath>

#include "limn/util/angles.h"

namespace limn {
namespace {

const double kMinCosine = std::cos(20 * kDeg);

// The unit direction in which a shape leaves its end.
Eigen::Vector3d Leaving(const CurveShape& shape, int end) {
  const Eigen::Vector3d derivative = end == 0 ? DerivativeAt(shape, 0) : -DerivativeAt(shape, 1);
  return derivative.normalized();
}

bool IsSpline(const CurveShape& shape) { return std::holds_alternative<CubicBSpline>(shape); }

void Share(const CurveShape& a, int end_a, const CurveShape& b, int end_b, EndCondition* at_a,
           EndCondition* at_b) {
  if (at_a->direction || at_b->direction) return;
  const Eigen::Vector3d leaving_a = Leaving(a, end_a);
  const Eigen::Vector3d leaving_b = Leaving(b, end_b);
  if (!leaving_a.allFinite() || !leaving_b.allFinite() || -leaving_a.dot(leaving_b) < kMinCosine) {
    return;
  }
  Eigen::Vector3d shared = (leaving_a - leaving_b).normalized();
  if (!IsSpline(a)) shared = leaving_a;
  if (IsSpline(a) && !IsSpline(b)) shared = -leaving_b;
  if (IsSpline(a)) at_a->direction = shared;
  if (IsSpline(b)) at_b->direction = -shared;
}

}  // namespace

std::vector<EndConditions> EndsOfLinks(const DrawingGraph& graph) {
  std::vector<EndConditions> ends(graph.links.size());
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    if (link.closed) continue;
    ends[l][0].held = graph.nodes[link.node0].Degree() > 1;
    ends[l][1].held = graph.nodes[link.node1].Degree() > 1;
  }
  return ends;
}

void ShareDirections(const DrawingGraph& graph, const std::vector<const CurveShape*>& shapes,
                     std::vector<EndConditions>* ends) {
  for (const DrawingNode& node : graph.nodes) {
    for (const auto& [a, b] : node.continuations) {
      if (shapes[a.link] == nullptr || shapes[b.link] == nullptr || a.link == b.link) continue;
      Share(*shapes[a.link], a.end, *shapes[b.link], b.end, &(*ends)[a.link][a.end],
            &(*ends)[b.link][b.end]);
    }
  }
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (!graph.links[l].closed || shapes[l] == nullptr || !IsSpline(*shapes[l])) continue;
    EndConditions& of_link = (*ends)[l];
    Share(*shapes[l], 0, *shapes[l], 1, &of_link[0], &of_link[1]);
    // The joint stays where it is while the direction is given to both sides of it.
    of_link[0].held = of_link[1].held = of_link[0].direction.has_value();
  }
}

}  // namespace limn
