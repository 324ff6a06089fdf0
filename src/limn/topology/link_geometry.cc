// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/link_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>

#include <Eigen/Eigenvalues>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/parabola.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// The tip of a link lies between these distances from its end, px: fits and detectors round what is
// nearer, and longer tips make more false junctions.
constexpr double kTipSkipPx = 2;
constexpr double kTipLengthPx = 12;
// A bend is measured on tips of at least this many points.
constexpr size_t kMinBendPoints = 5;
constexpr int kSeamReach = 4;
constexpr int kMaxProbes = 60;
// Upper limit of a standard deviation, px.
constexpr double kWeakSigmaPx = 30;

}  // namespace

const Eigen::Vector3d& EndPoint(const DrawingLink& link, int end) {
  return end == 0 ? link.points_in_world.front() : link.points_in_world.back();
}

AxisLine FitLine(std::span<const Eigen::Vector3d> points) {
  AxisLine line;
  for (const Eigen::Vector3d& point : points) {
    line.mean += point / static_cast<double>(points.size());
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    scatter += (point - line.mean) * (point - line.mean).transpose();
  }
  line.direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  return line;
}

LinkVertex Bare(const LinkVertex& vertex) {
  return {vertex.information, vertex.footprint, 0, {}, {}};
}

LinkTip TipOf(const DrawingLink& link, int end, double footprint) {
  const std::vector<Eigen::Vector3d>& points = link.points_in_world;
  const int size = link.size();
  const auto at = [&](int k) -> const Eigen::Vector3d& {
    return points[end == 0 ? k : size - 1 - k];
  };
  LinkTip tip;
  tip.point = at(0);
  tip.footprint = footprint;
  std::vector<Eigen::Vector3d> reached;
  std::vector<double> arcs_px;
  size_t num_rounded = 0;
  double arc_px = 0;
  for (int k = 0; k < size && arc_px <= kTipSkipPx + kTipLengthPx; ++k) {
    if (k > 0) arc_px += (at(k) - at(k - 1)).norm() / footprint;
    num_rounded += arc_px < kTipSkipPx;
    reached.push_back(at(k));
    arcs_px.push_back(arc_px);
  }
  // Short links are used whole; where few points remain, all that were reached are.
  const bool is_long = arc_px >= kTipSkipPx + kTipLengthPx && reached.size() >= num_rounded + 2;
  const auto used = std::span(reached).subspan(is_long ? num_rounded : 0);
  const auto [mean, axis] = FitLine(used);
  const Eigen::Vector3d outwards = used.front() - used.back();
  if (!(outwards.norm() > 0)) return tip;
  const Eigen::Vector3d direction = axis.dot(outwards) < 0 ? Eigen::Vector3d(-axis) : axis;
  tip.outward = tip.bent_outward = direction;
  if (is_long && used.size() >= kMinBendPoints) {
    const Parabola inward = FitParabola(used, std::span(arcs_px).subspan(num_rounded));
    tip.bent_outward = -inward.slope.stableNormalized();
  }
  tip.point = mean + direction * direction.dot(tip.point - mean);
  return tip;
}

double TurnBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.isZero(0) || b.isZero(0) ? M_PI / 2 : AngleBetween(a, b);
}

double TurnBetween(const LinkTip& a, const LinkTip& b) {
  return std::min(TurnBetween(a.outward, -b.outward), TurnBetween(a.bent_outward, -b.bent_outward));
}

double SeamTurn(const DrawingLink& link) {
  const std::vector<Eigen::Vector3d>& points = link.points_in_world;
  const int count = link.size() - 1;  // the last point is the first one
  const int reach = std::min(count / 8, kSeamReach);
  if (reach == 0) return M_PI;
  std::vector<double> turns;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d& before = points[(k + count - reach) % count];
    const Eigen::Vector3d& after = points[(k + reach) % count];
    turns.push_back(TurnBetween(points[k] - before, after - points[k]));
  }
  const double at_seam = turns.front();
  return std::max(0.0, at_seam - Median(std::move(turns)));
}

std::vector<std::pair<size_t, size_t>> SmoothPairs(const std::vector<LinkTip>& tips,
                                                   double max_turn_rad) {
  std::vector<std::tuple<double, size_t, size_t>> by_turn;
  for (size_t i = 0; i < tips.size(); ++i) {
    for (size_t j = i + 1; j < tips.size(); ++j) {
      const double turn = TurnBetween(tips[i], tips[j]);
      if (turn < max_turn_rad) by_turn.push_back({turn, i, j});
    }
  }
  std::sort(by_turn.begin(), by_turn.end());
  std::vector<uint8_t> used(tips.size(), 0);
  std::vector<std::pair<size_t, size_t>> pairs;
  for (const auto& [turn, i, j] : by_turn) {
    if (used[i] || used[j]) continue;
    used[i] = used[j] = 1;
    pairs.push_back({i, j});
  }
  return pairs;
}

LinkTip TipOf(const DrawingLink& link, int end) {
  if (link.vertices.empty()) return {EndPoint(link, end)};
  return TipOf(link, end, (end == 0 ? link.vertices.front() : link.vertices.back()).footprint);
}

double ArcPx(const DrawingLink& link, int from, int to) {
  double arc = 0;
  for (int i = from; i < to; ++i) {
    arc +=
        (link.points_in_world[i + 1] - link.points_in_world[i]).norm() / link.vertices[i].footprint;
  }
  return arc;
}

double LengthPx(const DrawingLink& link) { return ArcPx(link, 0, link.size() - 1); }

Eigen::Vector3d TangentAt(const DrawingLink& link, int index) {
  const int last = link.size() - 1;
  return (link.points_in_world[std::min(index + 1, last)] -
          link.points_in_world[std::max(index - 1, 0)])
      .stableNormalized();
}

std::vector<int> ProbePoints(const DrawingLink& link) {
  const int step = std::max(1, (link.size() + kMaxProbes - 1) / kMaxProbes);
  std::vector<int> points;
  for (int k = 0; k < link.size(); k += step) points.push_back(k);
  return points;
}

double WeakInformation(double footprint) { return 1 / std::pow(kWeakSigmaPx * footprint, 2); }

double SigmaAcross(const Eigen::Matrix3d& information, double footprint) {
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double weak = WeakInformation(footprint);
  return std::sqrt(0.5 * (1 / std::max(values[1], weak) + 1 / std::max(values[2], weak)));
}

int64_t NumSketchSamples(const DrawingLink& link) {
  int64_t count = 0;
  for (const LinkVertex& vertex : link.vertices) {
    count += static_cast<int64_t>(vertex.samples.size());
  }
  return count;
}

}  // namespace limn
