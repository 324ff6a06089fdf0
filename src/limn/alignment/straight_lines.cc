#include "limn/alignment/straight_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "limn/model/link_selection.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Of the chord, between it and the points of a straight link.
constexpr double kMaxBend = 0.01;
// Directions with this standard deviation count half.
constexpr double kHalfCertainRad = 1 * kDeg;

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

std::optional<LineSegment> LineOf(const DrawingLink& link) {
  if (!link.primitive) return ChordOf(link.points_in_world);
  const auto* line = std::get_if<LineSegment>(&link.primitive->shape);
  return line ? std::optional(*line) : std::nullopt;
}

// From 0 to 1. Both ends are off by the sigma of a point, or less.
double Certainty(const DrawingLink& link, double length) {
  double sum = 0;
  for (const double sigma : link.sigma) sum += sigma;
  const double sigma_rad = M_SQRT2 * sum / static_cast<double>(link.sigma.size()) / length;
  if (!std::isfinite(sigma_rad)) return 0.5;  // unknown
  return 1 / (1 + std::pow(sigma_rad / kHalfCertainRad, 2));
}

}  // namespace

std::vector<StraightLine> StraightLines(const DrawingGraph& graph) {
  const LinkSelection selection;
  std::vector<StraightLine> lines;
  for (const DrawingLink& link : graph.links) {
    if (link.closed || !selection.Has(link)) continue;
    const std::optional<LineSegment> line = LineOf(link);
    if (!line) continue;
    const Eigen::Vector3d chord = line->end - line->start;
    const double length = chord.norm();
    if (!(length > 0)) continue;
    lines.push_back(
        {chord / length, (line->start + line->end) / 2, length * Certainty(link, length)});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const StraightLine& a, const StraightLine& b) {
    return a.weight > b.weight;
  });
  if (lines.size() > kMaxStraightLines) lines.resize(kMaxStraightLines);
  return lines;
}

}  // namespace limn
