#include "limn/refinement/fitted_vertices.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// The point at or behind each arc length; both ascend.
std::vector<size_t> FirstNotBefore(const std::vector<double>& arc, const std::vector<double>& at) {
  std::vector<size_t> index;
  for (const double length : at) {
    const auto next = std::lower_bound(arc.begin(), arc.end(), length);
    index.push_back(std::min<size_t>(next - arc.begin(), arc.size() - 1));
  }
  return index;
}

}  // namespace

void GiveVertices(const std::vector<View>& views, const LinkMatches& matches, DrawingLink* link) {
  const double footprint = LinkFootprint(*link, views);
  if (!(footprint > 0)) return;
  const std::vector<double> arc = CumulativeLength(link->points_in_world);
  link->points_in_world = ResampleUniform(link->points_in_world, footprint);
  std::vector<double> sigma;
  for (const size_t k : FirstNotBefore(arc, CumulativeLength(link->points_in_world))) {
    sigma.push_back(link->sigma[k]);
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
