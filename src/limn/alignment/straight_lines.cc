// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/straight_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "limn/model/link_selection.h"
#include "limn/model/straight_link.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Directions with this standard deviation count half.
constexpr double kHalfCertainRad = 1 * kDeg;

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
    if (!selection.Has(link)) continue;
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
