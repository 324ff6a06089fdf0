// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/short_curves.h"

#include <algorithm>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// Limits were chosen: algorithm/belief.md#what-was-measured.
constexpr double kLikely = 0.5;
// Where all is uncertain, a link is unlikely if its confidence is below this share of the mean.
constexpr double kShareOfMean = 0.7;

bool IsJudged(const DrawingLink& link) {
  return !link.tentative && link.IsAlongEdgels() && link.kind != LinkKind::kTexture &&
         link.confidence >= 0;
}

// By length in px, so that what is near counts as much as what is far.
double MeanConfidence(const std::vector<View>& views, const DrawingGraph& graph) {
  double length_px = 0, sum = 0;
  for (const DrawingLink& link : graph.links) {
    const double footprint = LinkFootprint(link, views);
    if (!IsJudged(link) || !(footprint > 0)) continue;
    const double of_link = Length(link.points_in_world) / footprint;
    length_px += of_link;
    sum += of_link * link.confidence;
  }
  return length_px > 0 ? sum / length_px : 0;
}

}  // namespace

StageSummary DoubtShortCurves(const std::vector<View>& views, DrawingGraph* graph) {
  const double likely = std::min(kLikely, kShareOfMean * MeanConfidence(views, *graph));
  int64_t num_believed = 0, num_doubted = 0;
  for (DrawingLink& link : graph->links) {
    if (link.tentative) continue;
    ++num_believed;
    if (!link.IsOfShortCurve() || !IsJudged(link) || link.confidence >= likely) continue;
    ++num_doubted;
    link.tentative = true;
    link.doubt = LinkDoubt::kShort;
  }
  StageSummary summary;
  summary.stage = "short curves";
  summary.in = {{"links: believed", num_believed}};
  summary.kept = {{"links: believed", num_believed - num_doubted}};
  summary.dropped = {{"links: short and unlikely", num_doubted}};
  return summary;
}

void BelieveShortCurves(DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) {
    if (link.doubt != LinkDoubt::kShort) continue;
    link.tentative = false;
    link.doubt = LinkDoubt::kNone;
  }
}

}  // namespace limn
