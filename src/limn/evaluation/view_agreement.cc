// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/view_agreement.h"

#include <optional>

#include "limn/model/link_selection.h"

namespace limn {
namespace {

double LengthInView(const View& view, const Polyline3d& points) {
  double length = 0;
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  bool was_seen = false;
  for (const Eigen::Vector3d& point : points) {
    const std::optional<Eigen::Vector2d> pixel = view.Project(point);
    if (was_seen && pixel) length += (*pixel - before).norm();
    was_seen = pixel.has_value();
    if (pixel) before = *pixel;
  }
  return length;
}

}  // namespace

std::vector<ViewAgreement> MeasureAgreement(const std::vector<View>& views,
                                            const std::vector<ImageCurves>& curves,
                                            const DrawingGraph& graph) {
  std::vector<double> lengths(views.size(), 0);
  const LinkSelection selection = LinkSelection::AsSeen();
  for (const DrawingLink& link : graph.links) {
    if (!selection.Has(link)) continue;
    for (const ViewId v : link.supporting_views) {
      lengths[v] += LengthInView(views[v], link.points_in_world);
    }
  }
  std::vector<ViewAgreement> agreements(views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    for (const CurveFragment& fragment : curves[v].fragments) {
      agreements[v].num_edgels += std::ssize(fragment.edgel_ids);
    }
    if (agreements[v].num_edgels == 0) continue;
    agreements[v].share = lengths[v] / static_cast<double>(agreements[v].num_edgels);
  }
  return agreements;
}

}  // namespace limn
