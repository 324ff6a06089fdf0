// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/drawing_samples.h"

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"

namespace limn {
DrawingSamples SampleDrawing(const DrawingGraph& graph, const std::vector<View>& views,
                             double spacing_px) {
  DrawingSamples samples;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    const double footprint = LinkFootprint(link, views);
    if (!(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, spacing_px * footprint);
    for (size_t k = 1; k < points.size(); ++k) {
      const Eigen::Vector3d chord = points[k] - points[k - 1];
      if (!(chord.norm() > 0)) continue;
      const Eigen::Vector3d position = 0.5 * (points[k] + points[k - 1]);
      const double here = LinkFootprint(link, position, views);
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
