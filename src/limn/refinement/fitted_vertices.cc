#include "limn/refinement/fitted_vertices.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"

namespace limn {

void GiveVertices(const std::vector<View>& views, const LinkMatches& matches, DrawingLink* link) {
  const double footprint = LinkFootprint(*link, views);
  if (!(footprint > 0)) return;
  const std::vector<double> arc = CumulativeLength(link->points_in_world);
  link->points_in_world = ResampleUniform(link->points_in_world, footprint);
  std::vector<double> sigma;
  for (const double at : CumulativeLength(link->points_in_world)) {
    const auto next = std::lower_bound(arc.begin(), arc.end() - 1, at);
    sigma.push_back(link->sigma[next - arc.begin()]);
  }
  link->sigma = std::move(sigma);
  link->vertices.resize(link->points_in_world.size());
  for (LinkVertex& vertex : link->vertices) vertex.footprint = footprint;
  const double step = arc.back() / static_cast<double>(link->size() - 1);
  for (const LinkSample& sample : matches) {
    const double at = (1 - sample.t) * arc[sample.segment] + sample.t * arc[sample.segment + 1];
    LinkVertex& vertex = link->vertices[std::lround(at / step)];
    for (const EdgelPull& pull : sample.pulls) vertex.support.push_back(pull.ref);
  }
  for (LinkVertex& vertex : link->vertices) {
    std::sort(vertex.support.begin(), vertex.support.end());
    const auto end = std::unique(vertex.support.begin(), vertex.support.end());
    vertex.support.erase(end, vertex.support.end());
  }
}

}  // namespace limn
