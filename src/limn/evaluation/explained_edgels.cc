// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/explained_edgels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/model/link_selection.h"
#include "limn/support/edgel_index.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/same_edge.h"

namespace limn {
namespace {

constexpr double kStepPx = 1.5;
constexpr double kMaxSteps = 20000;  // of a link

struct Explanation {
  Polyline3d points;  // about a step apart
  const std::vector<ViewId>& views;
  bool is_firm = false;
};

std::vector<Explanation> ExplanationsOf(const std::vector<View>& views, const DrawingGraph& graph) {
  const LinkSelection firm = LinkSelection::AsSeen();
  std::vector<Explanation> explanations;
  for (const DrawingLink& link : graph.links) {
    const bool is_firm = firm.Has(link);
    const double footprint = LinkFootprint(link, views);
    if (!(footprint > 0) || !(is_firm || link.doubt == LinkDoubt::kExplained)) continue;
    const double step = std::max(kStepPx * footprint, Length(link.points_in_world) / kMaxSteps);
    explanations.push_back(
        {ResampleUniform(link.points_in_world, step), link.supporting_views, is_firm});
  }
  return explanations;
}

class ViewExplanation {
 public:
  ViewExplanation(const View& view, const ImageCurves& curves)
      : view_(view),
        edgels_(curves.edge_map.edgels),
        index_(curves.edge_map, LinkedEdgels(curves)),
        explained_(edgels_.size()) {}

  void Add(const Explanation& explanation) {
    const Polyline3d& points = explanation.points;
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      const auto px = view_.Project(points[k]);
      if (!px) continue;
      const auto direction = ProjectedDirection(view_, points[k], points[k + 1] - points[k]);
      if (!direction) continue;
      const auto depth = static_cast<float>((view_.cam_from_world * points[k]).z());
      index_.ForEachWithin(*px, kSameEdgePx, [&](EdgelId id) {
        const double angle = edgels_[id].tangent_rad;
        const Eigen::Vector2d tangent(std::cos(angle), std::sin(angle));
        if (std::abs(tangent.dot(*direction)) < kSameDirectionCosine) return;
        ExplainedEdgel& edgel = explained_[id];
        edgel.near = edgel.near > 0 ? std::min(edgel.near, depth) : depth;
        edgel.far = std::max(edgel.far, depth);
        edgel.is_firm |= explanation.is_firm;
      });
    }
  }

  std::vector<ExplainedEdgel> Take() { return std::move(explained_); }

 private:
  const View& view_;
  const std::vector<Edgel>& edgels_;
  EdgelIndex index_;
  std::vector<ExplainedEdgel> explained_;
};

}  // namespace

std::vector<std::vector<ExplainedEdgel>> FindExplainedEdgels(const std::vector<View>& views,
                                                             const std::vector<ImageCurves>& curves,
                                                             const DrawingGraph& graph,
                                                             const RunContext& context) {
  const std::vector<Explanation> explanations = ExplanationsOf(views, graph);
  std::vector<std::vector<ExplainedEdgel>> explained(views.size());
  ParallelFor(context, "explained edgels", views.size(), [&](size_t v) {
    ViewExplanation of_view(views[v], curves[v]);
    for (const Explanation& explanation : explanations) {
      const bool supports = std::ranges::binary_search(explanation.views, static_cast<ViewId>(v));
      if (supports) of_view.Add(explanation);
    }
    explained[v] = of_view.Take();
  });
  return explained;
}

double ShareAtOtherDepths(const std::vector<std::vector<ExplainedEdgel>>& explained) {
  int64_t num_explained = 0, num_other = 0;
  for (const std::vector<ExplainedEdgel>& of_view : explained) {
    for (const ExplainedEdgel& edgel : of_view) {
      num_explained += edgel.near > 0;
      num_other += AreAtOtherDepths(edgel.near, edgel.far);
    }
  }
  return num_explained > 0 ? static_cast<double>(num_other) / static_cast<double>(num_explained)
                           : 0;
}

}  // namespace limn
