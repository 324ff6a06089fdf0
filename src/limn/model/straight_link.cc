// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/straight_link.h"

#include <variant>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Of the chord, between it and the points of a straight link.
constexpr double kMaxBend = 0.01;

std::optional<LineSegment> ChordOf(const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d chord = points.back() - points.front();
  const double length = chord.norm();
  for (const Eigen::Vector3d& point : points) {
    if ((point - points.front()).cross(chord).norm() > kMaxBend * length * length) {
      return std::nullopt;
    }
  }
  return LineSegment{points.front(), points.back()};
}

}  // namespace

std::optional<LineSegment> LineOf(const DrawingLink& link) {
  if (link.closed) return std::nullopt;
  if (!link.primitive) return ChordOf(link.points_in_world);
  const auto* line = std::get_if<LineSegment>(&link.primitive->shape);
  return line ? std::optional(*line) : std::nullopt;
}

}  // namespace limn
