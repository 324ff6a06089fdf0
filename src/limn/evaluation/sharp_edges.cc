#include "limn/evaluation/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include <Eigen/Geometry>

#include "limn/formats/curve_chains.h"
#include "limn/geometry/polygon_triangulation.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Angles given exactly are met in spite of rounding.
constexpr double kAngleSlackRad = 1e-9;

// A side of a polygon, at its edge a < b.
struct Side {
  int a = 0;
  int b = 0;
  int polygon = 0;
  // Unit vector in the polygon, across the side, towards the polygon's inside.
  Eigen::Vector3d inwards;
};

double Angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::vector<Side> SidesByEdge(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  for (size_t p = 0; p < mesh.polygons.size(); ++p) {
    const std::vector<int>& polygon = mesh.polygons[p];
    const Eigen::Vector3d area = PolygonAreaVector(CornersOf(mesh, polygon));
    for (size_t k = 0; k < polygon.size(); ++k) {
      const int from = polygon[k];
      const int to = polygon[(k + 1) % polygon.size()];
      const Eigen::Vector3d along = mesh.vertices[to] - mesh.vertices[from];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(p),
                       area.normalized().cross(along.normalized()).normalized()});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.a, s.b) < std::tie(t.a, t.b);
  });
  return sides;
}

// Of the sides of all polygons at one edge.
bool IsSharp(std::span<const Side> sides, double min_bend_rad) {
  if (sides.size() != 2) return true;
  const double bend = M_PI - Angle(sides[0].inwards, sides[1].inwards);
  return bend >= min_bend_rad - kAngleSlackRad;
}

EdgeSoup SharpEdgesOf(const TriangleMesh& mesh, double min_bend_rad) {
  EdgeSoup soup;
  soup.vertices = mesh.vertices;
  const std::vector<Side> sides = SidesByEdge(mesh);
  for (size_t begin = 0; begin < sides.size();) {
    size_t end = begin + 1;
    while (end < sides.size() && sides[end].a == sides[begin].a && sides[end].b == sides[begin].b) {
      ++end;
    }
    if (IsSharp({sides.data() + begin, end - begin}, min_bend_rad)) {
      soup.edges.emplace_back(sides[begin].a, sides[begin].b);
    }
    begin = end;
  }
  return soup;
}

bool TurnsAt(const Eigen::Vector3d& before, const Eigen::Vector3d& at, const Eigen::Vector3d& after,
             double max_turn_rad) {
  return Angle(at - before, after - at) > max_turn_rad + kAngleSlackRad;
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
