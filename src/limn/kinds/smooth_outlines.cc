// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/smooth_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/kinds/outline_fit.h"
#include "limn/kinds/round_body_fit.h"
#include "limn/support/view_edgels.h"
#include "limn/util/logistic.h"
#include "limn/util/map_items.h"
#include "limn/util/median.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// A smaller radius is that of a rounded edge, px.
constexpr double kMinBodyPx = 3;
// Edgels of an outline may be this much farther from it than edgels usually are from edges.
constexpr double kMaxRmsRatio = 1.6;
// Least evidence of an outline, of one that speaks for others, and of one that no other speaks for;
// the last must be shown by this share of the views where it is not at the place of the edge, and
// by this many.
constexpr double kMinOutlineRatio = 0.3;
constexpr double kSpeaksRatio = 1;
constexpr double kAloneRatio = 4;
constexpr double kAloneShownShare = 0.4;
constexpr int kMinMovedShown = 2;
constexpr size_t kAlonePlaces = 4;
constexpr int kMinSpeakers = 2;
// Outlines agree on a body if its radii differ by at most this share of the larger one, and at
// least half of the axis points of one lie within this share of it, or 2 px, of the other axis.
constexpr double kRadiusTolerance = 0.25;
constexpr double kAxisTolerance = 0.25;
constexpr double kMinTolerancePx = 2;

double RadiusOf(const OutlineEvidence& evidence) { return std::abs(evidence.body.radius); }

bool MayBeOutline(const OutlineEvidence& evidence, double usual_rms_px) {
  return evidence.log_ratio > kMinOutlineRatio &&
         RadiusOf(evidence) > kMinBodyPx * evidence.footprint &&
         evidence.body_rms_px < kMaxRmsRatio * usual_rms_px;
}

bool IsOutlineAlone(const OutlineEvidence& evidence) {
  return evidence.log_ratio > kAloneRatio && evidence.body.axis.size() >= kAlonePlaces &&
         evidence.num_moved_shown >= kMinMovedShown &&
         evidence.num_moved_shown >= kAloneShownShare * evidence.num_moved;
}

bool HalfLieNear(const Polyline3d& points, const Polyline3d& line, double reach) {
  const auto distance_of = [&](const Eigen::Vector3d& point) {
    return line.size() == 1 ? (point - line.front()).norm()
                            : std::sqrt(ClosestPoint(line, point).squared_distance);
  };
  const auto num_near = std::ranges::count_if(
      points, [&](const Eigen::Vector3d& point) { return distance_of(point) < reach; });
  return 2 * num_near >= std::ssize(points);
}

Eigen::AlignedBox3d BoxAround(const Polyline3d& points, double reach) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(reach);
  return {box.min() - margin, box.max() + margin};
}

bool AgreeOnBody(const OutlineEvidence& a, const OutlineEvidence& b) {
  const double larger = std::max(RadiusOf(a), RadiusOf(b));
  if (std::abs(RadiusOf(a) - RadiusOf(b)) > kRadiusTolerance * larger) return false;
  const double reach =
      std::max(kMinTolerancePx * std::max(a.footprint, b.footprint), kAxisTolerance * larger);
  if (!BoxAround(a.body.axis, reach).intersects(BoxAround(b.body.axis, 0))) return false;
  return HalfLieNear(a.body.axis, b.body.axis, reach) ||
         HalfLieNear(b.body.axis, a.body.axis, reach);
}

// The median over the links; how far edgels usually are from edges.
double UsualRms(const std::vector<OutlineEvidence>& links) {
  std::vector<double> values;
  for (const OutlineEvidence& link : links) {
    if (link.edge_rms_px > 0) values.push_back(link.edge_rms_px);
  }
  return Median(std::move(values));
}

// Whether enough of the candidates agree with a link.
bool HasSpeakers(const std::vector<OutlineEvidence>& links, const std::vector<size_t>& candidates,
                 size_t link) {
  int num_speakers = 0;
  for (const size_t other : candidates) {
    if (other == link || links[other].log_ratio <= kSpeaksRatio) continue;
    num_speakers += AgreeOnBody(links[link], links[other]);
    if (num_speakers == kMinSpeakers) return true;
  }
  return false;
}

// Per link, whether it is the outline of a smooth body.
std::vector<uint8_t> AreOutlines(const std::vector<OutlineEvidence>& links) {
  const double usual_rms_px = UsualRms(links);
  std::vector<size_t> candidates;
  for (size_t l = 0; l < links.size(); ++l) {
    if (MayBeOutline(links[l], usual_rms_px)) candidates.push_back(l);
  }
  std::vector<uint8_t> are_outlines(links.size(), 0);
  for (const size_t l : candidates) {
    are_outlines[l] = IsOutlineAlone(links[l]) || HasSpeakers(links, candidates, l);
  }
  return are_outlines;
}

// Outlines that agree on a body, directly or through others, in the order of their first.
std::vector<std::vector<size_t>> OutlinesOfBodies(const std::vector<OutlineEvidence>& links,
                                                  const std::vector<uint8_t>& are_outlines) {
  std::vector<size_t> outlines;
  for (size_t l = 0; l < links.size(); ++l) {
    if (are_outlines[l]) outlines.push_back(l);
  }
  UnionFind sets(outlines.size());
  for (size_t i = 0; i < outlines.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const bool are_together = sets.Find(static_cast<int>(i)) == sets.Find(static_cast<int>(j));
      if (!are_together && AgreeOnBody(links[outlines[i]], links[outlines[j]])) sets.Union(i, j);
    }
  }
  std::map<size_t, std::vector<size_t>> by_root;
  for (size_t i = 0; i < outlines.size(); ++i) by_root[sets.Find(i)].push_back(outlines[i]);
  std::vector<std::vector<size_t>> bodies;
  for (auto& [root, members] : by_root) bodies.push_back(std::move(members));
  return bodies;
}

// Gives outlines the bodies that fit them; returns how many there are.
int64_t TellBodies(const TopologyInput& images, const ViewFinder& finder,
                   const std::vector<OutlineEvidence>& evidence,
                   const std::vector<std::vector<size_t>>& outlines, const RunContext& context,
                   std::vector<DrawingLink>* links) {
  const auto bodies = MapItems(context, "round bodies", outlines.size(), [&](size_t b) {
    std::vector<OutlineSight> sights;
    for (const size_t l : outlines[b]) {
      const auto of_link = SightsOfOutline(images, finder, (*links)[l], evidence[l].body);
      sights.insert(sights.end(), of_link.begin(), of_link.end());
    }
    return FitRoundBody(sights);
  });
  for (size_t b = 0; b < outlines.size(); ++b) {
    for (const size_t l : outlines[b]) (*links)[l].body = bodies[b];
  }
  return std::ranges::count_if(bodies, [](const auto& body) { return body.has_value(); });
}

}  // namespace

OutlinesResult FindSmoothOutlines(const OutlinesInput& input, const RunContext& context) {
  const std::vector<View>& views = input.scene.views;
  const auto edgels = BuildViewEdgels(input.scene.curves, context);
  const TopologyInput images = {views, input.scene.curves, edgels, {}, input.scene.box};
  const ViewFinder finder(views);
  OutlinesResult result = {WithoutOutlines(input.graph), {}};
  std::vector<DrawingLink>& links = result.graph.links;
  std::vector<OutlineEvidence> evidence(links.size());
  ParallelFor(context, "outlines of smooth bodies", links.size(), [&](size_t l) {
    if (links[l].tentative || links[l].kind == LinkKind::kRod) return;
    evidence[l] = CompareWithBodies(images, finder, links[l]);
  });
  const std::vector<uint8_t> are_outlines = AreOutlines(evidence);
  for (size_t l = 0; l < links.size(); ++l) {
    if (!are_outlines[l]) continue;
    links[l].kind = LinkKind::kContour;
    links[l].kind_confidence = Logistic(evidence[l].log_ratio);
  }
  int64_t num_bodies = 0;
  if (input.fit_bodies) {
    num_bodies = TellBodies(images, finder, evidence, OutlinesOfBodies(evidence, are_outlines),
                            context, &links);
  }
  result.summary.stage = "outlines of smooth bodies";
  result.summary.in = {{"links", std::ssize(links)}};
  result.summary.kept = {{"links: outlines", std::ranges::count(are_outlines, 1)},
                         {"round bodies", num_bodies}};
  return result;
}

DrawingGraph WithoutOutlines(DrawingGraph graph) {
  for (DrawingLink& link : graph.links) {
    if (link.kind != LinkKind::kContour) continue;
    link.kind = LinkKind::kUnknown;
    link.body.reset();
    link.kind_confidence = 0;
  }
  return graph;
}

}  // namespace limn
