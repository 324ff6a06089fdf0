// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/confidence.h"

#include <algorithm>
#include <cmath>

#include "limn/belief/measured_depth.h"
#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/util/logistic.h"

namespace limn {
namespace {

// Weights of the regression; for how they were found see algorithm/belief.md#what-was-measured.
constexpr double kBase = 0.34;
constexpr double kPerEvidence = 0.09;
constexpr double kPerFreeEnd = -0.82;
constexpr double kPerLogViews = 0.67;
constexpr double kPerLogSure = 1.21;
// More evidence than this makes nothing surer.
constexpr double kMaxEvidence = 20;
// Of unsure links whose edgels stand still hardly one is right.
constexpr double kStillFactor = 0.1;
// Keeps the logarithm of the sure share finite.
constexpr double kLeastSureShare = 0.02;

int NumFree(const DrawingGraph& graph, const DrawingLink& link) {
  return (graph.nodes[link.node0].Degree() < 2) + (graph.nodes[link.node1].Degree() < 2);
}

// In px, so that what is near counts as much as what is far.
double SureShare(const std::vector<View>& views, const DrawingGraph& graph) {
  double whole = 0;
  double sure = 0;
  for (const DrawingLink& link : graph.links) {
    const double footprint = LinkFootprint(link, views);
    if (!link.evidence || !(footprint > 0)) continue;
    const double length_px = Length(link.points_in_world) / footprint;
    whole += length_px;
    if (*link.evidence >= kSureEvidence) sure += length_px;
  }
  return whole > 0 ? sure / whole : 0;
}

}  // namespace

double ConfidenceOf(const LinkFacts& facts, double sure_share) {
  const double log_odds = kBase + kPerEvidence * std::min(facts.evidence, kMaxEvidence) +
                          kPerFreeEnd * facts.num_free +
                          kPerLogViews * std::log1p(static_cast<double>(facts.num_views)) +
                          kPerLogSure * std::log(sure_share + kLeastSureShare);
  const double measured =
      facts.tri_angle_deg < 0 ? 1 : std::min(1.0, facts.tri_angle_deg / kWideAngleDeg);
  return measured * Logistic(log_odds);
}

void TellConfidences(const std::vector<View>& views, DrawingGraph* graph) {
  const double sure_share = SureShare(views, *graph);
  for (DrawingLink& link : graph->links) {
    link.confidence = -1;
    if (link.kind == LinkKind::kRod) link.confidence = link.kind_confidence;
    if (!link.evidence || link.kind == LinkKind::kContour) continue;
    link.confidence = ConfidenceOf(
        {*link.evidence, link.supporting_views.size(), NumFree(*graph, link), link.tri_angle_deg},
        sure_share);
    const bool is_still = link.doubt == LinkDoubt::kStill && *link.evidence < kSureEvidence;
    if (is_still) link.confidence *= kStillFactor;
  }
}

}  // namespace limn
