// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/find_rods.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/model/view_finder.h"
#include "limn/rods/draw_rod.h"
#include "limn/rods/fit_rod.h"
#include "limn/rods/grow_rod.h"
#include "limn/rods/rod_evidence.h"
#include "limn/rods/rod_limits.h"
#include "limn/rods/rod_seeds.h"
#include "limn/rods/rod_sights.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/topology_input.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

constexpr SupportGate kSeedGates[] = {{2.0, 1.0, 30 * kDeg}, {2.0, 1.0, 30 * kDeg},
                                      {1.5, 1.0, 25 * kDeg}, {1.5, 1.0, 25 * kDeg},
                                      {1.0, 1.0, 20 * kDeg}, {1.0, 1.0, 20 * kDeg}};
constexpr SupportGate kFinalGates[] = {
    {1.5, 1.0, 25 * kDeg}, {1.0, 1.0, 20 * kDeg}, {1.0, 1.0, 20 * kDeg}};
constexpr SupportGate kShownRodGate = {1.0, 1.0, 20 * kDeg};
// Wide enough for the edges of a strip that is seen from the side.
constexpr SupportGate kCompareGate = {2.0, 1.0, 20 * kDeg};
constexpr double kMinShownRodShare = 0.7;
// A view shows a rod at this many places.
constexpr int kMinShownPlaces = 3;
// Shortest rod, px and in thicknesses.
constexpr double kMinRodPx = 20;
constexpr double kMinThicknesses = 5;
// How well a rod must explain the edgels, and how much better than two fixed lines.
constexpr int kMinRodViews = 6;
constexpr double kMinLogRatio = 0.5;
constexpr double kMaxRodRmsPx = 0.36;
// The same of a short piece, which is extended before it is judged.
constexpr double kMaxPieceRmsPx = 0.42;
// A seed is part of a rod if this share of its axis is within its outlines and this many px.
constexpr double kSameShare = 0.5;
constexpr double kSamePx = 1.5;
// Rods that are extended at the same time, whatever the number of threads: they do not see each
// other.
constexpr size_t kGrownTogether = 8;

bool IsThin(const Rod& rod) {
  const double radius_px = rod.radius / rod.footprint;
  return radius_px >= kMinRadiusPx && radius_px <= kMaxRadiusPx;
}

bool IsLong(const Rod& rod) {
  return Length(rod.axis) >= std::max(kMinRodPx * rod.footprint, 2 * kMinThicknesses * rod.radius);
}

// Views that show a rod at enough places, ascending.
std::vector<ViewId> ViewsOf(std::span<const RodPlace> places) {
  std::map<ViewId, int> shown;
  for (const RodPlace& place : places) {
    for (const RodSight& sight : place.sights) ++shown[sight.view];
  }
  std::vector<ViewId> views;
  for (const auto& [view, count] : shown) {
    if (count >= kMinShownPlaces) views.push_back(view);
  }
  return views;
}

class RodFinder {
 public:
  RodFinder(const RodInput& input, const RunContext& context)
      : views_(input.scene.views),
        edgels_(BuildViewEdgels(input.scene.curves, context)),
        images_{views_, input.scene.curves, edgels_, {}, input.scene.box},
        finder_(views_) {}

  std::vector<FoundRod> Find(const DrawingGraph& graph, const RunContext& context) const {
    const std::vector<RodSeed> seeds = FindRodSeeds(views_, graph, context);
    const auto fitted = MapItems(context, "rods", seeds.size(), [&](size_t s) {
      const auto found = Fitted(seeds[s].rod, seeds[s].views, kSeedGates);
      return found && MayBeRod(found->evidence) ? std::optional(found->rod) : std::nullopt;
    });
    std::vector<Rod> suggested;
    for (const std::optional<Rod>& rod : fitted) {
      if (rod) suggested.push_back(*rod);
    }
    std::ranges::stable_sort(suggested, std::greater<>(),
                             [](const Rod& rod) { return Length(rod.axis) / rod.footprint; });
    Decided decided;
    for (size_t begin = 0; begin < suggested.size(); begin += kGrownTogether) {
      const size_t size = std::min(kGrownTogether, suggested.size() - begin);
      std::vector<std::optional<FoundRod>> grown(size);
      ParallelFor(PartOf(context, begin, suggested.size()), "long rods", size,
                  [&](size_t i) { grown[i] = Grown(suggested[begin + i], decided); });
      for (std::optional<FoundRod>& rod : grown) {
        if (rod && !IsPartOfOne(rod->rod, decided.rods)) Decide(*std::move(rod), &decided);
      }
    }
    return std::move(decided.found);
  }

 private:
  struct Decided {
    std::vector<FoundRod> found;
    std::vector<Rod> rods;     // of found
    std::vector<Rod> refused;  // where two fixed lines are better
  };

  // Nothing if the rod is part of one that was decided on, or none.
  std::optional<FoundRod> Grown(Rod rod, const Decided& decided) const {
    if (IsPartOfOne(rod, decided.rods) || IsPartOfOne(rod, decided.refused)) return std::nullopt;
    GrowRod(images_, finder_, decided.rods, &rod);
    auto grown = Fitted(rod, finder_.NearAnyOf(rod.axis), kFinalGates);
    return grown && IsLong(grown->rod) ? std::move(grown) : std::nullopt;
  }

  static void Decide(FoundRod rod, Decided* decided) {
    if (rod.evidence.log_ratio < 0) decided->refused.push_back(rod.rod);
    if (!IsRod(rod.evidence)) return;
    decided->rods.push_back(rod.rod);
    decided->found.push_back(std::move(rod));
  }

  // Nothing if the images do not show a rod.
  std::optional<FoundRod> Fitted(Rod rod, std::span<const ViewId> views,
                                 std::span<const SupportGate> gates) const {
    FitRod(images_, views, gates, 0, &rod);
    if (!IsThin(rod)) return std::nullopt;
    FoundRod found;
    const auto places = LookAlongRod(images_, rod, 0, views, kShownRodGate);
    if (ShownShare(places) < kMinShownRodShare) return std::nullopt;
    found.views = ViewsOf(places);
    found.evidence =
        CompareWithFixedLines(images_, rod, LookAlongRod(images_, rod, 0, views, kCompareGate));
    found.rod = std::move(rod);
    return found;
  }

  // Of a short piece of one.
  static bool MayBeRod(const RodEvidence& evidence) {
    return evidence.log_ratio > 0 && evidence.rms_px <= kMaxPieceRmsPx;
  }

  static bool IsRod(const RodEvidence& evidence) {
    return evidence.num_views >= kMinRodViews && evidence.log_ratio >= kMinLogRatio &&
           evidence.rms_px <= kMaxRodRmsPx;
  }

  static bool IsPartOfOne(const Rod& rod, const std::vector<Rod>& rods) {
    return std::ranges::any_of(rods, [&](const Rod& other) {
      const auto num_beside = std::ranges::count_if(
          rod.axis, [&](const Eigen::Vector3d& point) { return IsBeside(other, point, kSamePx); });
      return static_cast<double>(num_beside) >= kSameShare * static_cast<double>(rod.axis.size());
    });
  }

  const std::vector<View>& views_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
  TopologyInput images_;
  ViewFinder finder_;
};

}  // namespace

DrawingGraph WithoutRods(DrawingGraph graph) {
  std::vector<uint8_t> keep;
  for (DrawingLink& link : graph.links) {
    keep.push_back(link.kind != LinkKind::kRod);
    if (link.doubt != LinkDoubt::kRodOutline) continue;
    link.doubt = LinkDoubt::kNone;
    link.tentative = false;
  }
  if (std::ranges::count(keep, 0) > 0) RemoveLinks(keep, &graph);
  return graph;
}

RodResult FindRods(const RodInput& input, const RunContext& context) {
  RodResult result;
  result.graph = WithoutRods(input.graph);
  const auto num_links = std::ssize(result.graph.links);
  const std::vector<FoundRod> rods = RodFinder(input, context).Find(result.graph, context);
  const int64_t num_outlines = DrawRods(rods, &result.graph);
  result.summary.stage = "rods";
  result.summary.in = {{"links", num_links}};
  result.summary.kept = {{"rods", std::ssize(rods)}};
  result.summary.dropped = {{"links: outlines of rods", num_outlines}};
  return result;
}

}  // namespace limn
