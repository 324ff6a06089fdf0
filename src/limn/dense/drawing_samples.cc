#include "limn/dense/drawing_samples.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/polyline.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

double MedianFootprint(const Eigen::Vector3d& point, const std::vector<ViewId>& ids,
                       const std::vector<View>& views) {
  std::vector<double> footprints;
  for (const ViewId id : ids) {
    if (const auto footprint = Footprint(views[id], point)) footprints.push_back(*footprint);
  }
  if (footprints.empty()) return 0;
  const auto middle = footprints.begin() + static_cast<std::ptrdiff_t>(footprints.size() / 2);
  std::nth_element(footprints.begin(), middle, footprints.end());
  return *middle;
}

}  // namespace

DrawingSamples SampleDrawing(const DrawingGraph& graph, const std::vector<View>& views,
                             double spacing_px) {
  DrawingSamples samples;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    const Eigen::Vector3d& middle = link.points_in_world[link.points_in_world.size() / 2];
    const double footprint = MedianFootprint(middle, link.supporting_views, views);
    if (!(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, spacing_px * footprint);
    for (size_t k = 1; k < points.size(); ++k) {
      const Eigen::Vector3d chord = points[k] - points[k - 1];
      if (!(chord.norm() > 0)) continue;
      const Eigen::Vector3d position = 0.5 * (points[k] + points[k - 1]);
      const double here = MedianFootprint(position, link.supporting_views, views);
      samples.position.push_back(position);
      samples.tangent.push_back(chord.normalized());
      samples.footprint.push_back(here > 0 ? here : footprint);
      samples.length.push_back(chord.norm());
      samples.link.push_back(static_cast<LinkId>(l));
    }
  }
  return samples;
}

}  // namespace limn
