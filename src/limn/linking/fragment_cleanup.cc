// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/fragment_cleanup.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "limn/geometry/angle_between.h"
#include "limn/linking/edgel_grid.h"
#include "limn/linking/fragment_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using Eigen::Vector2d;

// Smoothing rounds a corner over this distance from its apex.
constexpr double kCornerRadiusPx = 1.5;
// A corner turns this much more than the curve beside it.
constexpr double kMinCornerExcessRad = 0.4;
// Directions of chain ends are taken over this length.
constexpr double kEndArmPx = 5;
// A gap must be within this distance of the straight continuation of either end.
constexpr double kMaxBridgeOffsetPx = 1.0;
// A stem heads for a bar within about 45 degrees.
constexpr double kMinHeadingCosine = 0.7;
// Where two ends turn by more they do not continue each other, degrees.
constexpr double kMaxBridgeAngleDeg = 25;
// Straight arms on either side of a vertex that turn by at least this show a corner: shorter arms
// are noise, longer ones see the next corner.
constexpr double kCornerArmPx = 5;
constexpr double kCornerAngleDeg = 35;
// Because of smoothing a stem ends about two detection sigmas before its bar.
constexpr double kJunctionDistancePx = 3.5;
// Shorter stems are noise beside their bar.
constexpr double kJunctionStemPx = 15;
// Below this angle to the bar a stem runs along it.
constexpr double kJunctionAngleDeg = 30;

// Turning between the arms on both sides of each vertex. Angles are made when they are asked for:
// most vertices plainly do not turn enough.
class Turning {
 public:
  Turning(const FragmentPath& path, double arm_px) : turned_(path.size(), kUnknown) {
    for (int i = 0; i < path.size(); ++i) {
      const auto back = path.ArmAt(i, -1, kCornerRadiusPx, kCornerRadiusPx + arm_px);
      if (back.reach_px < kCornerRadiusPx + 0.5 * arm_px) continue;
      const auto front = path.ArmAt(i, 1, kCornerRadiusPx, kCornerRadiusPx + arm_px);
      if (front.reach_px < kCornerRadiusPx + 0.5 * arm_px) continue;
      const Vector2d along = -back.direction;
      turned_[i] = {along.dot(front.direction),
                    along.x() * front.direction.y() - along.y() * front.direction.x()};
    }
  }

  // False only if At(i) is below the angle of this cosine.
  bool MayReach(int i, double cosine) const { return turned_[i].x() <= cosine + 1e-9; }
  // -1 near the ends of an open chain.
  double At(int i) const {
    if (turned_[i] == kUnknown) return -1;
    return std::abs(std::atan2(turned_[i].y(), turned_[i].x()));
  }

 private:
  // No cosine is as large.
  inline static const Vector2d kUnknown{2, 0};
  std::vector<Vector2d> turned_;  // cosine and sine
};

// One and a half standard deviations of the turning of a straight chain of edgels like this one: a
// line fitted to n points over the arm errs by sqrt(12 / n) sigma / arm, neighboring edgels share
// their noise (n = arm / 2), and there are two arms.
double TurningNoise(const Edgel& edgel, double arm_px) {
  return 1.5 * std::sqrt(2 * 24 / arm_px) * edgel.position_sigma_px / arm_px;
}

// Turning beside vertex i, one arm away: the mean of both sides, or the one side where the chain
// goes on far enough to tell.
double TurningBeside(const FragmentPath& path, const Turning& turning, int i, double arm_px) {
  double sum = 0;
  int sides = 0;
  for (const int direction : {-1, 1}) {
    int last = i;
    path.Walk(i, direction, kCornerRadiusPx + arm_px, [&](int j, double) { last = j; });
    if (last == i || turning.At(last) < 0) continue;
    sum += turning.At(last);
    ++sides;
  }
  return sides > 0 ? sum / sides : 0;
}

bool IsLargestWithin(const FragmentPath& path, const Turning& turning, int i, double reach_px) {
  const double here = turning.At(i);
  bool largest = true;
  for (const int direction : {-1, 1}) {
    path.Walk(i, direction, reach_px, [&](int j, double) {
      const double there = turning.At(j);
      if (there > here || (there == here && j < i)) largest = false;
    });
  }
  return largest;
}

// One end of an open chain.
struct ChainEnd {
  EdgelId id;
  Vector2d position;
  Vector2d along;  // unit, in the direction of the chain's order
  double chain_length_px;
};

struct ChainEnds {
  std::vector<ChainEnd> heads;  // first edgels
  std::vector<ChainEnd> tails;  // last edgels
};

ChainEnds CollectEnds(const std::vector<Edgel>& edgels, const Chaining& chaining) {
  ChainEnds ends;
  for (const CurveFragment& chain : TraceChains(chaining)) {
    if (chain.closed) continue;
    const FragmentPath path(edgels, chain);
    const int last = path.size() - 1;
    ends.heads.push_back({chain.edgel_ids[0], path.Point(0),
                          path.ArmAt(0, 1, 0, kEndArmPx).direction, path.Length()});
    ends.tails.push_back({chain.edgel_ids[last], path.Point(last),
                          -path.ArmAt(last, -1, 0, kEndArmPx).direction, path.Length()});
  }
  return ends;
}

struct Bridge {
  double cost;
  EdgelId from;
  EdgelId to;

  bool operator<(const Bridge& other) const {
    return std::tie(cost, from, to) < std::tie(other.cost, other.from, other.to);
  }
};

// The cost of continuing from the tail to the head; negative if they must not be joined.
double BridgeCost(const ChainEnd& tail, const ChainEnd& head, const LinkingOptions& options) {
  const Vector2d gap = head.position - tail.position;
  const double length = gap.norm();
  const double angle = AngleBetween2d(tail.along, head.along);
  const double max_angle = kMaxBridgeAngleDeg * kDeg;
  if (length > options.max_bridge_px || angle > max_angle) return -1;
  // A chain is not joined over a gap that is longer than itself.
  if (length > std::min(tail.chain_length_px, head.chain_length_px)) return -1;
  double worst = angle;
  for (const Vector2d& along : {tail.along, head.along}) {
    const double forward = gap.dot(along);
    const double offset = std::abs(gap.x() * along.y() - gap.y() * along.x());
    if (forward <= 0 || offset > kMaxBridgeOffsetPx) return -1;
    // The offset has noise of its own: half a pixel is free.
    worst = std::max(worst, std::atan2(std::max(0.0, offset - 0.5), forward));
  }
  return worst <= max_angle ? length * (1 + worst / max_angle) : -1;
}

// Which chain an edgel is on and where.
struct ChainIndex {
  std::vector<CurveFragment> chains;
  std::vector<FragmentPath> paths;
  std::vector<int> chain_of;     // of an edgel, -1: none
  std::vector<int> position_of;  // of an edgel in its chain

  ChainIndex(const std::vector<Edgel>& edgels, const Chaining& chaining)
      : chains(TraceChains(chaining)), chain_of(edgels.size(), -1), position_of(edgels.size(), -1) {
    for (size_t c = 0; c < chains.size(); ++c) {
      paths.emplace_back(edgels, chains[c]);
      for (size_t k = 0; k < chains[c].edgel_ids.size(); ++k) {
        chain_of[chains[c].edgel_ids[k]] = static_cast<int>(c);
        position_of[chains[c].edgel_ids[k]] = static_cast<int>(k);
      }
    }
  }

  double ArcLength(EdgelId id) const { return paths[chain_of[id]].ArcLength(position_of[id]); }

  // Is the edgel at least this far from both ends of its chain?
  bool IsInterior(EdgelId id, double margin_px) const {
    if (chain_of[id] < 0) return false;
    const FragmentPath& path = paths[chain_of[id]];
    return path.closed() || std::min(ArcLength(id), path.Length() - ArcLength(id)) >= margin_px;
  }
};

// The nearest interior edgel of another chain that a chain end heads for at an angle, or none.
EdgelId BarOfStem(const std::vector<Edgel>& edgels, const LinkingOptions& options,
                  const ChainIndex& index, const EdgelGrid& grid, const ChainEnd& stem,
                  const Vector2d& outward) {
  EdgelId best = kInvalidEdgel;
  if (stem.chain_length_px < kJunctionStemPx) return best;
  const double min_angle = kJunctionAngleDeg * kDeg;
  double best_distance = 0;
  std::vector<EdgelId> near;
  grid.Near(stem.position, kJunctionDistancePx, &near);
  for (const EdgelId id : near) {
    if (index.chain_of[id] == index.chain_of[stem.id]) continue;
    if (!index.IsInterior(id, options.min_length_px)) continue;
    const Vector2d gap = edgels[id].position_px - stem.position;
    const double distance = gap.norm();
    if (distance > 1 && gap.dot(outward) < kMinHeadingCosine * distance) continue;
    const double turn = AngleBetween2d(edgels[id].Tangent(), outward);
    if (std::min(turn, M_PI - turn) < min_angle) continue;
    if (best == kInvalidEdgel || distance < best_distance ||
        (distance == best_distance && id < best)) {
      best = id;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace

int BreakAtCorners(const std::vector<Edgel>& edgels, SmoothChains* known, Chaining* chaining) {
  const double arm = kCornerArmPx;
  const double min_turning = kCornerAngleDeg * kDeg;
  const double cosine = std::cos(min_turning);
  known->last_of.resize(edgels.size(), kInvalidEdgel);
  int breaks = 0;
  for (const CurveFragment& chain : TraceChains(*chaining)) {
    EdgelId& smooth_until = known->last_of[chain.edgel_ids.front()];
    if (!chain.closed && smooth_until == chain.edgel_ids.back()) continue;
    const FragmentPath path(edgels, chain);
    if (path.Length() < arm) continue;
    const Turning turning(path, arm);
    const int breaks_before = breaks;
    for (int i = 0; i < path.size(); ++i) {
      if (!turning.MayReach(i, cosine)) continue;
      const double here = turning.At(i);
      const double noise = TurningNoise(edgels[chain.edgel_ids[i]], arm);
      if (here < min_turning + noise || !IsLargestWithin(path, turning, i, arm)) continue;
      if (here - TurningBeside(path, turning, i, arm) < kMinCornerExcessRad + noise) continue;
      chaining->BreakAfter(chain.edgel_ids[i]);
      ++breaks;
    }
    if (!chain.closed && breaks == breaks_before) smooth_until = chain.edgel_ids.back();
  }
  return breaks;
}

int BridgeGaps(const std::vector<Edgel>& edgels, const LinkingOptions& options,
               Chaining* chaining) {
  if (options.max_bridge_px <= 0) return 0;
  const ChainEnds ends = CollectEnds(edgels, *chaining);
  // Heads are found through a grid of pseudo edgels at their positions.
  std::vector<Edgel> heads(ends.heads.size());
  for (size_t i = 0; i < heads.size(); ++i) heads[i].position_px = ends.heads[i].position;
  const EdgelGrid grid(heads, options.max_bridge_px);
  std::vector<Bridge> bridges;
  std::vector<EdgelId> near;
  for (const ChainEnd& tail : ends.tails) {
    near.clear();
    grid.Near(tail.position, options.max_bridge_px, &near);
    for (const EdgelId i : near) {
      const double cost = BridgeCost(tail, ends.heads[i], options);
      if (cost >= 0) bridges.push_back({cost, tail.id, ends.heads[i].id});
    }
  }
  std::sort(bridges.begin(), bridges.end());
  int joined = 0;
  for (const Bridge& bridge : bridges) {
    if (chaining->next[bridge.from] != kInvalidEdgel ||
        chaining->prev[bridge.to] != kInvalidEdgel) {
      continue;
    }
    chaining->Join(bridge.from, bridge.to);
    ++joined;
  }
  return joined;
}

int BreakAtJunctions(const std::vector<Edgel>& edgels, const LinkingOptions& options,
                     Chaining* chaining) {
  const ChainIndex index(edgels, *chaining);
  const EdgelGrid grid(edgels, std::max(1.0, kJunctionDistancePx));
  const ChainEnds ends = CollectEnds(edgels, *chaining);
  std::vector<EdgelId> bars;
  for (const ChainEnd& head : ends.heads) {
    bars.push_back(BarOfStem(edgels, options, index, grid, head, -head.along));
  }
  for (const ChainEnd& tail : ends.tails) {
    bars.push_back(BarOfStem(edgels, options, index, grid, tail, tail.along));
  }
  std::sort(bars.begin(), bars.end());
  std::vector<std::vector<double>> broken_at(index.chains.size());
  int count = 0;
  for (const EdgelId bar : bars) {
    if (bar == kInvalidEdgel) continue;
    const double at = index.ArcLength(bar);
    std::vector<double>& taken = broken_at[index.chain_of[bar]];
    const bool is_near = std::any_of(taken.begin(), taken.end(), [&](double other) {
      return std::abs(other - at) < options.min_length_px;
    });
    if (is_near) continue;
    taken.push_back(at);
    chaining->BreakAfter(bar);
    ++count;
  }
  return count;
}

}  // namespace limn
