// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/classify_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "limn/kinds/cast_shadows.h"
#include "limn/util/logistic.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMinProfiles = 3;
// Weights and limits were fitted: algorithm/kinds.md#what-was-measured. A step that is blurrier
// than sharp ones by this factor is soft.
constexpr double kSoftRatio = 1.4;
constexpr double kSoftSlope = 6.7;
constexpr double kSoftOffset = -1.94;
// Light changes brightness, paint color too: a shadow changes no channel more than this.
constexpr double kMaxShadowChroma = 0.3;
// A shadow's ratio of light is nearly the same at neighboring places; that of soft texture is not.
constexpr double kMaxShadowUnevenness = 0.1;
// A cast shadow has more of its length behind other links; the rest is gaps in what casts it.
constexpr double kMinShareBehind = 0.6;
// The light of the scene changes if sides of links differ by this between views, and by that
// between views that are exposed alike; then a link whose sides do not differ in the views as they
// are is seen in one light only.
constexpr double kChangingLight = 0.2;
constexpr double kBeyondExposure = 0.06;
constexpr double kOneLightShare = 0.3;
constexpr int kMinViewsOfOneLight = 3;
// What is soft, and seen in several lights with one ratio, is paint: light changes the ratio of
// the sides of a rounded crease as much as the sides.
constexpr double kSteadyRatioShare = 0.5;
constexpr double kMinLightOnPaint = 0.15;
// Paint: the color changes, by the same in all views.
constexpr double kPaintPerChroma = 5.4;
constexpr double kPaintPerLogSpread = -1.1;
constexpr double kPaintOffset = -6.0;
constexpr double kMinSpread = 0.02;

// Of a link whose sides have one hue: nothing if it is sharp and no shadow.
std::optional<KindOfLink> ClassifyByLight(const KindEvidence& evidence, const SceneLight& light) {
  const bool is_soft = evidence.blur_ratio > kSoftRatio;
  if (light.variation > kChangingLight && light.change > kBeyondExposure) {
    const auto [steadier, other] = std::minmax(evidence.darker_spread, evidence.brighter_spread);
    if (evidence.num_views >= kMinViewsOfOneLight && other < kOneLightShare * light.variation) {
      return KindOfLink{LinkKind::kShadow, 1 - other / light.variation};
    }
    const double ratio_share = evidence.change_spread / std::max(steadier, kMinSpread);
    if (is_soft && steadier > kMinLightOnPaint && ratio_share < kSteadyRatioShare) {
      return KindOfLink{LinkKind::kPaint, 1 - ratio_share};
    }
  } else if (is_soft && evidence.unevenness < kMaxShadowUnevenness) {
    return KindOfLink{LinkKind::kShadow,
                      Logistic(kSoftSlope * std::log(evidence.blur_ratio) + kSoftOffset)};
  }
  return is_soft ? std::optional(KindOfLink{}) : std::nullopt;
}

StageSummary Summarize(const DrawingGraph& graph) {
  std::array<int64_t, kNumLinkKinds> counts = {};
  for (const DrawingLink& link : graph.links) ++counts[static_cast<int>(link.kind)];
  StageSummary summary;
  summary.stage = "kinds of edges";
  summary.in = {{"links", static_cast<int64_t>(graph.links.size())}};
  for (const LinkKind kind : {LinkKind::kEdge, LinkKind::kPaint, LinkKind::kShadow,
                              LinkKind::kContour, LinkKind::kRod, LinkKind::kUnknown}) {
    summary.kept.emplace_back(std::string("links: ") + LinkKindName(kind),
                              counts[static_cast<int>(kind)]);
  }
  return summary;
}

}  // namespace

SceneLight LightOf(const std::vector<KindEvidence>& links) {
  std::vector<double> variations;
  std::vector<double> changes;
  for (const KindEvidence& link : links) {
    if (link.num_views < kMinViewsOfOneLight) continue;
    variations.push_back(std::min(link.darker_spread, link.brighter_spread));
    changes.push_back(link.steadier_spread_exposed);
  }
  return {Median(std::move(variations)), Median(std::move(changes))};
}

KindOfLink Classify(const KindEvidence& evidence, const SceneLight& light) {
  if (evidence.num_profiles < kMinProfiles) return {};
  if (evidence.chroma_change < kMaxShadowChroma) {
    if (evidence.share_behind > kMinShareBehind) return {LinkKind::kShadow, evidence.share_behind};
    if (auto kind = ClassifyByLight(evidence, light)) return *kind;
  }
  const double paint = Logistic(
      kPaintPerChroma * evidence.chroma_change +
      kPaintPerLogSpread * std::log(std::max(evidence.change_spread, kMinSpread)) + kPaintOffset);
  return paint > 0.5 ? KindOfLink{LinkKind::kPaint, paint} : KindOfLink{LinkKind::kEdge, 1 - paint};
}

KindsResult ClassifyKinds(const KindsInput& input, const RunContext& context) {
  const ProfilePlan plan = PlanProfiles(input.graph, input.views);
  std::vector<std::vector<LinkProfile>> profiles(input.views.size());
  ParallelFor(context, "kinds of edges", input.views.size(), [&](size_t v) {
    const std::vector<LinkId>& links = plan.links_of_view[v];
    if (links.empty()) return;
    profiles[v] =
        MeasureProfiles(input.views[v], input.read_image(static_cast<ViewId>(v)), plan, links);
  });
  std::vector<KindEvidence> evidence = GatherEvidence(input.graph.links.size(), profiles);
  const std::vector<double> shares_behind = SharesBehind(input.graph, input.views, context);
  for (size_t l = 0; l < evidence.size(); ++l) evidence[l].share_behind = shares_behind[l];
  const SceneLight light = LightOf(evidence);
  KindsResult result = {input.graph, {}};
  for (size_t l = 0; l < evidence.size(); ++l) {
    DrawingLink& link = result.graph.links[l];
    if (!link.IsAlongEdgels()) continue;
    const KindOfLink kind = Classify(evidence[l], light);
    link.kind = kind.kind;
    link.kind_confidence = kind.confidence;
  }
  result.summary = Summarize(result.graph);
  return result;
}

}  // namespace limn
