// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/finish_links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "limn/topology/meetings.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Smallest spacing of points, px.
constexpr double kMinSpacingPx = 0.5;
// A supporting view has edgels at this many points of a link or more.
constexpr int kMinSupportedPoints = 3;

std::vector<LinkMember> Members(const DrawingLink& link) {
  std::vector<SketchSample> all;
  for (const LinkVertex& vertex : link.vertices) {
    all.insert(all.end(), vertex.samples.begin(), vertex.samples.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<LinkMember> members;
  for (const SketchSample& from : all) {
    if (!members.empty() && members.back().curve == from.curve &&
        members.back().end == from.sample) {
      ++members.back().end;
    } else {
      members.push_back({from.curve, from.sample, from.sample + 1});
    }
  }
  return members;
}

std::vector<ViewId> SupportingViews(const DrawingLink& link) {
  std::map<ViewId, int> num_points;
  for (const LinkVertex& vertex : link.vertices) {
    ViewId last = -1;
    for (const EdgelRef& ref : vertex.support) {
      num_points[ref.view] += ref.view != last;
      last = ref.view;
    }
  }
  std::vector<ViewId> views;
  for (const auto& [view, count] : num_points) {
    if (count >= kMinSupportedPoints) views.push_back(view);
  }
  return views;
}

double MedianResidualPx(const TopologyInput& input, const DrawingLink& link) {
  std::vector<double> residuals;
  for (int k = 0; k < link.size(); ++k) {
    for (const EdgelRef& ref : link.vertices[k].support) {
      const auto residual = input.Residual(ref, link.points_in_world[k]);
      if (residual) residuals.push_back(std::abs(residual->residual_px));
    }
  }
  return Median(std::move(residuals));
}

void ThinOut(DrawingLink* link) {
  std::vector<Eigen::Vector3d>& points = link->points_in_world;
  const int last = link->size() - 1;
  int kept = 0;
  const auto keep = [&](int k) {
    points[kept] = points[k];
    link->sigma[kept++] = link->sigma[k];
  };
  keep(0);
  for (int k = 1; k < last; ++k) {
    const double spacing = kMinSpacingPx * link->vertices[k].footprint;
    const bool is_near_end = (points[k] - points[last]).norm() < spacing && last - k < 3;
    if (!is_near_end && (points[k] - points[kept - 1]).norm() >= spacing) keep(k);
  }
  keep(last);
  points.resize(kept);
  link->sigma.resize(kept);
}

}  // namespace

void FinishLinks(const TopologyInput& input, const TopologyOptions& options, DrawingGraph* graph) {
  PairContinuations(options, graph);
  for (DrawingLink& link : graph->links) {
    link.members = Members(link);
    link.supporting_views = SupportingViews(link);
    link.residual_px = MedianResidualPx(input, link);
    ThinOut(&link);
    link.vertices = {};
  }
}

}  // namespace limn
