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
// A seed is part of a rod if this share of its axis is within its outlines and this many px.
constexpr double kSameShare = 0.5;
constexpr double kSamePx = 1.5;

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
    const std::vector<Rod> seeds = FindRodSeeds(views_, graph, context);
    const auto fitted = MapItems(context, "rods", seeds.size(), [&](size_t s) {
      const auto found = Fitted(seeds[s], kSeedGates);
      return found && MayBeRod(found->evidence) ? std::optional(found->rod) : std::nullopt;
    });
    std::vector<Rod> suggested;
    for (const std::optional<Rod>& rod : fitted) {
      if (rod) suggested.push_back(*rod);
    }
    std::ranges::stable_sort(suggested, std::greater<>(),
                             [](const Rod& rod) { return Length(rod.axis) / rod.footprint; });
    std::vector<FoundRod> found;
    std::vector<Rod> rods;
    std::vector<Rod> refused;  // where two fixed lines are better
    for (Rod& rod : suggested) {
      ThrowIfCancelled(context);
      if (IsPartOfOne(rod, rods) || IsPartOfOne(rod, refused)) continue;
      GrowRod(images_, finder_, rods, &rod);
      auto grown = Fitted(rod, kFinalGates);
      if (!grown || !IsLong(grown->rod) || IsPartOfOne(grown->rod, rods)) continue;
      if (grown->evidence.log_ratio < 0) refused.push_back(grown->rod);
      if (!IsRod(grown->evidence)) continue;
      rods.push_back(grown->rod);
      found.push_back(*std::move(grown));
    }
    return found;
  }

 private:
  // Nothing if the images do not show a rod.
  std::optional<FoundRod> Fitted(Rod rod, std::span<const SupportGate> gates) const {
    const std::vector<ViewId> views = finder_.NearAnyOf(rod.axis);
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
  static bool MayBeRod(const RodEvidence& evidence) { return evidence.log_ratio > 0; }

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
