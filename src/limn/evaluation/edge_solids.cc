// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/edge_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kMinEdgeLength = 1e-6;

struct Span {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  void Cut(double low, double high) {
    from = std::max(from, low);
    to = std::min(to, high);
  }
  bool IsEmpty() const { return !(from < to); }
};

auto EndOrder(const Eigen::Vector3d& end) { return std::tuple(end.x(), end.y(), end.z()); }

auto EdgeOrder(const EdgeSolid& solid) {
  return std::tuple(EndOrder(solid.start), EndOrder(solid.end));
}

Slab SlabBetweenEnds(const EdgeSolid& solid) {
  const Eigen::Vector3d along = solid.end - solid.start;
  const Eigen::Vector3d direction = along.normalized();
  return {direction, direction.dot(solid.start + solid.end) / 2, along.norm() / 2};
}

// The axes that the program of the challenge gives a cylinder of unit height along z: where the
// edge is oblique x and y are not perpendicular to it, and one of them is shorter.
Eigen::Matrix3d ChallengeAxes(const Eigen::Vector3d& direction) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.col(2) = direction;
  if (std::abs(direction.x()) < std::abs(direction.y())) {
    axes.col(1) = direction.cross(Eigen::Vector3d::UnitX());
  } else {
    axes.col(0) = Eigen::Vector3d::UnitY().cross(direction);
  }
  return axes;
}

// Three pairs of sides, around a hexagon with a corner on the x axis, and the two ends.
std::vector<Slab> SlabsOfPrism(const EdgeSolid& solid) {
  const Eigen::Vector3d along = solid.end - solid.start;
  const Eigen::Vector3d middle = (solid.start + solid.end) / 2;
  const Eigen::Matrix3d local = ChallengeAxes(along.normalized()).inverse();
  std::vector<Slab> slabs;
  const auto add = [&](const Eigen::Vector3d& local_normal, double half_width) {
    const Eigen::Vector3d normal = local.transpose() * local_normal;
    slabs.push_back({normal, normal.dot(middle), half_width});
  };
  for (const double angle_deg : {30, 90, 150}) {
    add({std::cos(angle_deg * kDeg), std::sin(angle_deg * kDeg), 0},
        solid.radius * std::cos(30 * kDeg));
  }
  add(Eigen::Vector3d::UnitZ(), along.norm() / 2);
  return slabs;
}

void CutBySlab(const Slab& slab, double x, double y, Span* span) {
  const double at = slab.normal.x() * x + slab.normal.y() * y - slab.offset;
  const double slope = slab.normal.z();
  if (slope == 0) {
    if (std::abs(at) > slab.half_width) span->to = span->from;
    return;
  }
  const auto [low, high] =
      std::minmax({(-slab.half_width - at) / slope, (slab.half_width - at) / slope});
  span->Cut(low, high);
}

void CutByRound(const EdgeSolid& solid, double x, double y, Span* span) {
  const Eigen::Vector3d axis = (solid.end - solid.start).normalized();
  // Across the axis: of the line's point at the height of the start, and of its direction.
  const Eigen::Vector3d offset(x - solid.start.x(), y - solid.start.y(), 0);
  const Eigen::Vector3d across = offset - axis * axis.dot(offset);
  const Eigen::Vector3d step = Eigen::Vector3d::UnitZ() - axis * axis.z();
  const double squared_step = step.squaredNorm();
  const double radius_squared = solid.radius * solid.radius;
  if (squared_step < 1e-24) {  // along the axis
    if (across.squaredNorm() > radius_squared) span->to = span->from;
    return;
  }
  const double nearest = -across.dot(step) / squared_step;
  const double left = radius_squared - (across + nearest * step).squaredNorm();
  if (!(left > 0)) {
    span->to = span->from;
    return;
  }
  const double half = std::sqrt(left / squared_step);
  span->Cut(solid.start.z() + nearest - half, solid.start.z() + nearest + half);
}

}  // namespace

std::vector<EdgeSolid> ThickenEdges(const Wireframe& wireframe, EdgeShape shape, double radius) {
  std::vector<EdgeSolid> solids;
  for (const auto& [a, b] : wireframe.edges) {
    EdgeSolid solid{
        wireframe.vertices[a], wireframe.vertices[b], radius, shape == EdgeShape::kCylinder, {}};
    if (!((solid.end - solid.start).norm() >= kMinEdgeLength)) continue;
    // The same numbers from either end.
    if (EndOrder(solid.end) < EndOrder(solid.start)) std::swap(solid.start, solid.end);
    solid.slabs = solid.is_round ? std::vector{SlabBetweenEnds(solid)} : SlabsOfPrism(solid);
    solids.push_back(std::move(solid));
  }
  std::ranges::sort(solids, {}, EdgeOrder);
  const auto are_equal = [](const EdgeSolid& a, const EdgeSolid& b) {
    return EdgeOrder(a) == EdgeOrder(b);
  };
  solids.erase(std::unique(solids.begin(), solids.end(), are_equal), solids.end());
  return solids;
}

EdgeSolid Moved(EdgeSolid solid, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& translation) {
  solid.start = rotation * solid.start + translation;
  solid.end = rotation * solid.end + translation;
  for (Slab& slab : solid.slabs) {
    slab.normal = rotation * slab.normal;
    slab.offset += slab.normal.dot(translation);
  }
  return solid;
}

std::optional<std::pair<double, double>> ChordAlongZ(const EdgeSolid& solid, double x, double y) {
  Span span;
  if (solid.is_round) CutByRound(solid, x, y, &span);
  for (const Slab& slab : solid.slabs) {
    if (span.IsEmpty()) return std::nullopt;
    CutBySlab(slab, x, y, &span);
  }
  if (span.IsEmpty()) return std::nullopt;
  return std::pair(span.from, span.to);
}

}  // namespace limn
