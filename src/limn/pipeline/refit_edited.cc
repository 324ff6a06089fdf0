// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/refit_edited.h"

#include <algorithm>
#include <utility>

#include "limn/kinds/classify_kinds.h"
#include "limn/kinds/texture.h"
#include "limn/model/footprint.h"
#include "limn/pipeline/drawing_stages.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

// Shorter gaps are not judged, px: edges are rounded at corners.
constexpr double kMinGapPx = 3;
// Places of a link are in a gap if they are this near to the straight way through it, as a share of
// its length.
constexpr double kGapWidth = 0.5;
// Share of the places in a gap where the images must show an edge.
constexpr double kMinShownShare = 0.5;

bool LiesIn(const Eigen::Vector3d& place, const BridgedGap& gap) {
  const Eigen::Vector3d way = gap.to - gap.from;
  const double t = (place - gap.from).dot(way) / way.squaredNorm();
  const double aside = (place - gap.from - t * way).norm();
  return t >= 0 && t <= 1 && aside <= kGapWidth * way.norm();
}

void WarnOfGaps(const std::vector<std::vector<ShownPlace>>& shown, EditedDrawing* edited) {
  for (const BridgedGap& gap : edited->gaps) {
    if (!(gap.length_px > kMinGapPx)) continue;
    int num_places = 0;
    int num_shown = 0;
    for (const std::vector<ShownPlace>& link : shown) {
      for (const ShownPlace& place : link) {
        if (!LiesIn(place.position, gap)) continue;
        ++num_places;
        num_shown += place.num_views > 0;
      }
    }
    if (num_places == 0 || num_shown >= kMinShownShare * num_places) continue;
    std::string& warning = edited->outcomes[gap.edit].warning;
    warning += warning.empty() ? "" : "; ";
    warning += "the images show no edge along most of the gap of " + ShortNumber(gap.length_px) +
               " px that it closed";
  }
}

void TellKinds(const std::vector<View>& views, const std::function<Image(ViewId)>& read_image,
               const RunContext& context, EditedDrawing* edited) {
  if (!read_image) return;
  DrawingGraph& graph = edited->graph;
  KindsResult kinds = ClassifyKinds({views, read_image, graph}, context);
  MarkTexture(views, &kinds.graph);
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (!edited->touched[l] || edited->kind_by_hand[l]) continue;
    graph.links[l].kind = kinds.graph.links[l].kind;
    graph.links[l].kind_confidence = kinds.graph.links[l].kind_confidence;
  }
}

}  // namespace

StageSummary RefitEdited(const CurvesScene& scene, const std::function<Image(ViewId)>& read_image,
                         const PipelineOptions& options, const RunContext& context,
                         EditedDrawing* edited) {
  RefitResult refit = RefitLinks({{scene.views, scene.curves}, edited->graph}, edited->touched,
                                 options.refinement, context);
  WarnOfGaps(refit.shown, edited);
  edited->graph =
      RefitPrimitives(refit.graph, edited->touched, scene.views, options.primitives, context);
  MeasureLinks(scene.views, context, &edited->graph);
  TellKinds(scene.views, read_image, context, edited);
  SnapDimensions(scene.views, edited);
  StageSummary summary;
  summary.stage = "fit of edited links";
  const auto num_touched = std::ranges::count(edited->touched, 1);
  summary.in = {{"links", num_touched}};
  summary.kept = {
      {"links not fitted: too few views", num_touched - std::ranges::count(refit.fitted, 1)}};
  return summary;
}

}  // namespace limn
