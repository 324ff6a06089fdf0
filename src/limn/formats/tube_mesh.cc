// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/tube_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/Geometry>

namespace limn {
namespace {

constexpr int kTubeSides = 12;

// A cross-section of a tube.
struct TubeRing {
  Eigen::Vector3d center;
  Eigen::Vector3d tangent;
  Eigen::Vector3d x_axis;  // to its first corner

  Eigen::Vector3d NormalAt(int corner) const {
    const double angle = 2 * M_PI * corner / kTubeSides;
    return std::cos(angle) * x_axis + std::sin(angle) * tangent.cross(x_axis);
  }
};

// The axis that is across the other tangent and turns least on the way there.
Eigen::Vector3d Transported(const TubeRing& from, const Eigen::Vector3d& tangent) {
  return Eigen::Quaterniond::FromTwoVectors(from.tangent, tangent) * from.x_axis;
}

// At each point the mean direction of the steps before and after it.
std::vector<TubeRing> RingsAt(const Polyline3d& points, bool closed) {
  constexpr double kReturns = 1e-6;
  const size_t count = points.size();
  const auto direction = [&](size_t i) -> Eigen::Vector3d {
    return (points[(i + 1) % count] - points[i]).normalized();
  };
  std::vector<TubeRing> rings;
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d before = direction(i > 0 || closed ? (i + count - 1) % count : i);
    const Eigen::Vector3d after = i + 1 < count || closed ? direction(i) : before;
    const bool returns = (before + after).norm() < kReturns;
    const Eigen::Vector3d tangent = returns ? after : (before + after).normalized();
    rings.push_back({points[i], tangent,
                     i == 0 ? tangent.unitOrthogonal() : Transported(rings.back(), tangent)});
  }
  return rings;
}

// Turns the rings of a closed tube so that the last one meets the first.
void CloseRings(const Polyline3d& points, std::vector<TubeRing>* rings) {
  const TubeRing& first = rings->front();
  const Eigen::Vector3d arrived = Transported(rings->back(), first.tangent);
  const double missing =
      std::atan2(first.tangent.dot(arrived.cross(first.x_axis)), arrived.dot(first.x_axis));
  const std::vector<double> way = CumulativeLength(points);
  for (size_t i = 0; i < rings->size(); ++i) {
    TubeRing& ring = (*rings)[i];
    const double angle = missing * way[i] / way.back();
    ring.x_axis = Eigen::AngleAxisd(angle, ring.tangent) * ring.x_axis;
  }
}

void AddSides(const std::vector<TubeRing>& rings, bool closed, double radius, TubeMesh* tube) {
  for (const TubeRing& ring : rings) {
    for (int corner = 0; corner < kTubeSides; ++corner) {
      tube->normals.push_back(ring.NormalAt(corner));
      tube->vertices.push_back(ring.center + radius * tube->normals.back());
    }
  }
  const int count = static_cast<int>(rings.size());
  for (int i = 0; i < (closed ? count : count - 1); ++i) {
    const int from = kTubeSides * i, to = kTubeSides * ((i + 1) % count);
    for (int corner = 0; corner < kTubeSides; ++corner) {
      const int next = (corner + 1) % kTubeSides;
      tube->triangles.push_back({from + corner, from + next, to + next});
      tube->triangles.push_back({from + corner, to + next, to + corner});
    }
  }
}

void AddEnd(const TubeRing& ring, bool is_last, double radius, TubeMesh* tube) {
  const int first = static_cast<int>(tube->vertices.size());
  for (int corner = 0; corner < kTubeSides; ++corner) {
    tube->vertices.push_back(ring.center + radius * ring.NormalAt(corner));
    tube->normals.push_back(is_last ? ring.tangent : Eigen::Vector3d(-ring.tangent));
  }
  for (int corner = 1; corner + 1 < kTubeSides; ++corner) {
    const int at = first + corner;
    tube->triangles.push_back(is_last ? std::array{first, at, at + 1}
                                      : std::array{first, at + 1, at});
  }
}

}  // namespace

TubeMesh MakeTube(const Polyline3d& points, bool closed, double radius) {
  Polyline3d moving;
  std::unique_copy(points.begin(), points.end(), std::back_inserter(moving));
  Polyline3d places = moving;
  if (closed) places.pop_back();
  std::vector<TubeRing> rings = RingsAt(places, closed);
  if (closed) CloseRings(moving, &rings);
  TubeMesh tube;
  AddSides(rings, closed, radius, &tube);
  if (closed) return tube;
  AddEnd(rings.front(), /*is_last=*/false, radius, &tube);
  AddEnd(rings.back(), /*is_last=*/true, radius, &tube);
  return tube;
}

}  // namespace limn
