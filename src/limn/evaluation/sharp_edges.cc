// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "limn/evaluation/edge_sides.h"
#include "limn/formats/curve_chains.h"
#include "limn/geometry/angle_between.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Angles given exactly are met in spite of rounding.
constexpr double kAngleSlackRad = 1e-9;

EdgeSoup SharpEdgesOf(const TriangleMesh& mesh, double min_bend_rad) {
  EdgeSoup soup;
  soup.vertices = mesh.vertices;
  ForEachEdge(mesh.vertices, mesh.polygons, [&](std::span<const EdgeSide> sides) {
    const bool is_smooth =
        sides.size() == 2 && BendAt(sides[0], sides[1]) < min_bend_rad - kAngleSlackRad;
    if (!is_smooth) soup.edges.emplace_back(sides[0].a, sides[0].b);
  });
  return soup;
}

bool TurnsAt(const Eigen::Vector3d& before, const Eigen::Vector3d& at, const Eigen::Vector3d& after,
             double max_turn_rad) {
  const Eigen::Vector3d in = at - before;
  const Eigen::Vector3d out = after - at;
  return AngleBetween(in, out) > max_turn_rad + kAngleSlackRad;
}

// A closed chain begins at one of its corners, if it has any.
void BeginAtCorner(double max_turn_rad, Polyline3d* chain) {
  if (chain->size() < 4 || chain->front() != chain->back()) return;
  const size_t count = chain->size() - 1;
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d& before = (*chain)[(i + count - 1) % count];
    if (!TurnsAt(before, (*chain)[i], (*chain)[i + 1], max_turn_rad)) continue;
    chain->pop_back();
    std::rotate(chain->begin(), chain->begin() + static_cast<std::ptrdiff_t>(i), chain->end());
    chain->push_back(chain->front());
    return;
  }
}

void SplitAtCorners(const Polyline3d& chain, double max_turn_rad, std::vector<Polyline3d>* curves) {
  Polyline3d curve = {chain.front()};
  for (size_t i = 1; i < chain.size(); ++i) {
    curve.push_back(chain[i]);
    if (i + 1 < chain.size() && TurnsAt(chain[i - 1], chain[i], chain[i + 1], max_turn_rad)) {
      curves->push_back(std::move(curve));
      curve = {chain[i]};
    }
  }
  curves->push_back(std::move(curve));
}

}  // namespace

void SharpEdgeOptions::Check() const {
  LIMN_CHECK_RANGE(min_dihedral_deg, > 0, <= 180);
  LIMN_CHECK_RANGE(min_corner_deg, > 0, <= 180);
}

std::vector<Polyline3d> FindSharpEdges(const TriangleMesh& mesh, const SharpEdgeOptions& options) {
  options.Check();
  const EdgeSoup soup = SharpEdgesOf(mesh, options.min_dihedral_deg * kDeg);
  const double max_turn_rad = options.min_corner_deg * kDeg;
  std::vector<Polyline3d> curves;
  for (Polyline3d& chain : ChainEdges(soup).polylines) {
    BeginAtCorner(max_turn_rad, &chain);
    SplitAtCorners(chain, max_turn_rad, &curves);
  }
  return curves;
}

}  // namespace limn
