// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/curve_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "limn/util/angles.h"

namespace limn {
namespace {

const double kSameFaceCosine = std::cos(5 * kDeg);

std::vector<ViewId> ViewsOf(const std::vector<ViewId>& supporting, const SampleSupport& support) {
  std::vector<ViewId> both;
  std::set_intersection(supporting.begin(), supporting.end(), support.visible_in.begin(),
                        support.visible_in.end(), std::back_inserter(both));
  if (!both.empty()) return both;
  std::set_difference(supporting.begin(), supporting.end(), support.occluded_in.begin(),
                      support.occluded_in.end(), std::back_inserter(both));
  return both;
}

}  // namespace

Eigen::Vector3d CurvePoint::Outward(const std::vector<View>& all_views) const {
  Eigen::Vector3d direction = normals[0] + normals[1];
  if (!(direction.norm() > 0)) {
    for (const ViewId view : views) {
      direction += (all_views[view].CenterInWorld() - position).normalized();
    }
    direction -= direction.dot(tangent) * tangent;
  }
  return direction.norm() > 0 ? Eigen::Vector3d(direction.normalized()) : tangent.unitOrthogonal();
}

std::vector<CurvePoint> MakeCurvePoints(const DrawingGraph& graph, const DrawingSamples& samples,
                                        const std::vector<SampleSupport>& support,
                                        const DenseClasses& classes) {
  std::vector<CurvePoint> points;
  for (size_t s = 0; s < samples.size(); ++s) {
    const LinkId link = samples.link[s];
    if (classes.links[link].behind_surface) continue;
    CurvePoint point;
    point.position = samples.position[s];
    point.tangent = samples.tangent[s];
    point.footprint = samples.footprint[s];
    point.normals = support[s].normal;
    if (point.normals[0].dot(point.normals[1]) > kSameFaceCosine) {
      point.normals = {(point.normals[0] + point.normals[1]).normalized(), Eigen::Vector3d::Zero()};
    }
    point.views = ViewsOf(graph.links[link].supporting_views, support[s]);
    point.sample_class = classes.sample_class[s];
    point.link = link;
    if (!point.views.empty()) points.push_back(std::move(point));
  }
  return points;
}

}  // namespace limn
