// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/segment_support.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace limn {
namespace {

// Share of the length along which edgels must run, and the length at either end that corners round.
constexpr double kMinCoveredShare = 0.7;
constexpr double kRoundedPx = 1.5;
// Shorter projections are not tested.
constexpr double kMinProjectedPx = 3;

bool EdgelsRunAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                    const EdgelIndex& edgels, const SupportGate& gate) {
  const double length = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length;
  const double margin = std::min(kRoundedPx, length / 3);
  const int count = std::max(2, static_cast<int>(std::ceil(length - 2 * margin)) + 1);
  // Decided as soon as the rest cannot change the answer.
  const double required = kMinCoveredShare * count;
  int covered = 0;
  for (int i = 0; i < count && covered < required; ++i) {
    if (covered + count - i < required) return false;
    const double at = margin + (length - 2 * margin) * i / (count - 1);
    covered += edgels.Best(from + at * along, along, gate).has_value();
  }
  return covered >= required;
}

// Both ends in a view; nothing if one is outside the image or the segment is seen end on.
std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> ProjectSegment(
    const View& view, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const auto a = view.Project(from);
  const auto b = view.Project(to);
  if (!a || !b || (*b - *a).norm() < kMinProjectedPx) return std::nullopt;
  return std::pair(*a, *b);
}

}  // namespace

SegmentSupport FindSegmentSupport(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const std::vector<uint8_t>& visible,
                                  const std::vector<View>& views,
                                  const std::vector<std::unique_ptr<ViewEdgels>>& edgels,
                                  const SupportGate& gate) {
  SegmentSupport result;
  int num_copies = 0;
  int num_hits = 0;
  for (size_t v = 0; v < views.size(); ++v) {
    const auto ends = visible[v] ? ProjectSegment(views[v], from, to) : std::nullopt;
    if (!ends) continue;
    const auto& [a, b] = *ends;
    const EdgelIndex& index = edgels[v]->edgels;
    ++result.num_views;
    if (EdgelsRunAlong(a, b, index, gate)) result.seen_in.push_back(static_cast<ViewId>(v));
    const Eigen::Vector2d across = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
    for (const double shift : kChanceShiftsPx) {
      ++num_copies;
      num_hits += EdgelsRunAlong(a + shift * across, b + shift * across, index, gate);
    }
  }
  const double share = num_copies > 0 ? static_cast<double>(num_hits) / num_copies : 1;
  result.background = std::max(share, kMinChance);
  return result;
}

bool ShowsSegment(const View& view, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const EdgelIndex& edgels, const SupportGate& gate) {
  const auto ends = ProjectSegment(view, from, to);
  return ends && EdgelsRunAlong(ends->first, ends->second, edgels, gate);
}

double LogChance(double k, double n, double p) {
  if (n == 0 || k <= n * p) return 0;
  const double share = k / n;
  const double rest = share < 1 ? (1 - share) * std::log((1 - share) / (1 - p)) : 0;
  return -std::min<double>(n, kIndependentViews) * (share * std::log(share / p) + rest);
}

}  // namespace limn
