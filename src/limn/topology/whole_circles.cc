#include "limn/topology/whole_circles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/circle_through.h"
#include "limn/geometry/spatial_index.h"
#include "limn/topology/circle_evidence.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/meetings.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Radius of a circle, px.
constexpr double kMinRadiusPx = 2;
constexpr double kMaxRadiusPx = 250;
// A link suggests a circle if it turns by this much and lies this near to it; two links that meet,
// if they are the chords of a small one.
constexpr double kMinTurnRad = 60 * kDeg;
constexpr double kMaxArcMissPx = 2;
constexpr double kMaxChordsRadiusPx = 30;
constexpr double kMaxChordsMissPx = 2;
constexpr double kMeetPx = 4;
// Links run along a circle up to this distance and angle.
constexpr double kRimPx = 1.2;
constexpr double kRimRad = 35 * kDeg;
// The share of a circle along which links run, that images show, and the longest part that they may
// leave out.
constexpr double kMinDrawnShare = 0.4;
constexpr double kMinShownShare = 0.8;
constexpr double kMaxGapRad = 50 * kDeg;
constexpr int kMinRimViews = 3;
constexpr double kMaxRmsPx = 0.45;
constexpr SupportGate kShownGate = {1.0, 1.0, 20 * kDeg};
// A circle is drawn already if one link runs along this share of it. A link is part of a circle if
// this share of it runs along it.
constexpr double kWholeShare = 0.9;
constexpr double kPartShare = 0.8;

struct Candidate {
  CircularArc circle;
  double footprint = 0;
  std::vector<ViewId> views;  // that show the links it comes from
};

struct FoundCircle {
  CircularArc circle;
  double footprint = 0;
  std::vector<CirclePoint> points;
  double score = 0;  // number of its edgels
};

double MeanFootprint(const DrawingLink& link) {
  double sum = 0;
  for (const LinkVertex& vertex : link.vertices) sum += vertex.footprint;
  return sum / static_cast<double>(link.vertices.size());
}

// Largest distance of points from a circle.
double MissOf(const CircularArc& circle, std::span<const Vector3d> points) {
  double miss = 0;
  for (const Vector3d& point : points) {
    const Vector3d offset = point - circle.center;
    const double height = circle.Normal().dot(offset);
    const double radius = (offset - height * circle.Normal()).norm();
    miss = std::max(miss, std::hypot(height, radius - circle.radius));
  }
  return miss;
}

class CircleFinder {
 public:
  CircleFinder(const TopologyInput& input, GraphEditor* editor)
      : input_(input),
        editor_(*editor),
        places_(CollectPlaces(editor->graph())),
        index_(places_.position) {}

  CircleCounts Run(const RunContext& context) {
    CircleCounts counts;
    std::vector<FoundCircle> circles = Find(context);
    for (const FoundCircle& circle : circles) {
      const std::optional<int64_t> replaced = Draw(circle);
      if (!replaced) continue;
      ++counts.added;
      counts.replaced += *replaced;
    }
    editor_.Compact();
    return counts;
  }

 private:
  bool IsOpen(LinkId id) const {
    return editor_.IsLink(id) && !editor_.link(id).closed && !editor_.link(id).vertices.empty();
  }

  std::optional<Candidate> CandidateOf(std::span<const LinkId> ids, double max_radius_px,
                                       double max_miss_px) const {
    Candidate candidate;
    std::vector<Vector3d> points;
    for (const LinkId id : ids) {
      const DrawingLink& link = editor_.link(id);
      points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
      candidate.footprint += MeanFootprint(link) / static_cast<double>(ids.size());
      for (const LinkVertex& vertex : link.vertices) {
        for (const EdgelRef& ref : vertex.support) candidate.views.push_back(ref.view);
      }
    }
    SortUnique(&candidate.views);
    const auto circle = CircleThrough(points);
    if (!circle) return std::nullopt;
    const double radius_px = circle->radius / candidate.footprint;
    if (radius_px < kMinRadiusPx || radius_px > max_radius_px) return std::nullopt;
    if (MissOf(*circle, points) > max_miss_px * candidate.footprint) return std::nullopt;
    double length = 0;
    for (const LinkId id : ids) length += Length(editor_.link(id).points_in_world);
    if (length < kMinTurnRad * circle->radius) return std::nullopt;
    candidate.circle = *circle;
    return candidate;
  }

  std::vector<Candidate> Candidates() const {
    std::vector<Candidate> candidates;
    std::vector<Vector3d> ends;
    std::vector<LinkId> link_of_end;
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (!IsOpen(id)) continue;
      if (auto arc = CandidateOf(std::array{id}, kMaxRadiusPx, kMaxArcMissPx)) {
        candidates.push_back(std::move(*arc));
      }
      for (const int end : {0, 1}) {
        ends.push_back(EndPoint(editor_.link(id), end));
        link_of_end.push_back(id);
      }
    }
    const SpatialIndex index(ends);
    std::vector<SpatialIndex::Neighbor> near;
    std::set<std::pair<LinkId, LinkId>> pairs;
    for (size_t e = 0; e < ends.size(); ++e) {
      const LinkId id = link_of_end[e];
      index.FindWithin(ends[e], kMeetPx * editor_.link(id).vertices.front().footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const LinkId other = link_of_end[neighbor.index];
        if (other > id) pairs.insert({id, other});
      }
    }
    for (const auto& [a, b] : pairs) {
      auto chords = CandidateOf(std::array{a, b}, kMaxChordsRadiusPx, kMaxChordsMissPx);
      if (chords) candidates.push_back(std::move(*chords));
    }
    return candidates;
  }

  // The links that run along a circle, with the number of its points at which they do.
  struct Beside {
    std::map<LinkId, int> links;
    int num_drawn = 0;  // points with a link
  };
  Beside LinksBeside(const FoundCircle& found) const {
    Beside beside;
    std::vector<SpatialIndex::Neighbor> near;
    for (const CirclePoint& point : found.points) {
      index_.FindWithin(point.position, kRimPx * found.footprint, &near);
      std::set<LinkId> here;
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const auto& [id, k] = places_.point[neighbor.index];
        if (!editor_.IsLink(id) || cut_.contains(id)) continue;
        if (LineAngleBetween(TangentAt(editor_.link(id), k), point.tangent) > kRimRad) continue;
        here.insert(id);
      }
      beside.num_drawn += !here.empty();
      for (const LinkId id : here) ++beside.links[id];
    }
    return beside;
  }

  std::vector<FoundCircle> Find(const RunContext& context) const {
    const std::vector<Candidate> candidates = Candidates();
    const auto of_candidate =
        MapItems(context, "circles", candidates.size(),
                 [&](size_t c) { return CircleOf(candidates[c]); });
    std::vector<FoundCircle> circles;
    for (const auto& found : of_candidate) {
      if (found) circles.push_back(*found);
    }
    std::ranges::stable_sort(circles, std::greater<>(), &FoundCircle::score);
    return circles;
  }

  std::optional<FoundCircle> CircleOf(const Candidate& candidate) const {
    FoundCircle found = {FitCircleToEdgels(input_, candidate.circle, candidate.footprint,
                                           candidate.views),
                         candidate.footprint,
                         {},
                         0};
    const double radius_px = found.circle.radius / found.footprint;
    if (radius_px < kMinRadiusPx || radius_px > kMaxRadiusPx) return std::nullopt;
    found.points =
        LookAlongCircle(input_, found.circle, found.footprint, candidate.views, kShownGate);
    const auto size = static_cast<int>(found.points.size());
    int num_shown = 0;
    int gap = 0;
    int longest_gap = 0;
    for (int k = 0; k < 2 * size; ++k) {  // twice around: gaps go over the end
      const CirclePoint& point = found.points[k % size];
      const bool shown = std::ssize(point.support) >= kMinRimViews;
      gap = shown ? 0 : gap + 1;
      longest_gap = std::max(longest_gap, gap);
      if (k >= size) continue;
      num_shown += shown;
      found.score += static_cast<double>(point.support.size());
    }
    const Beside beside = LinksBeside(found);
    const double rms = RmsToEdgelsPx(input_, found.points);
    if (getenv("CIRC")) {
      fprintf(stderr, "circle %.2f %.2f %.2f r %.1f px: shown %.2f gap %.0f drawn %.2f rms %.2f\n",
              found.circle.center.x(), found.circle.center.y(), found.circle.center.z(), radius_px,
              num_shown / double(size), longest_gap * 360. / size, beside.num_drawn / double(size),
              rms);
    }
    if (num_shown < kMinShownShare * size || longest_gap * 2 * M_PI > kMaxGapRad * size ||
        beside.num_drawn < kMinDrawnShare * size || rms > kMaxRmsPx) {
      return std::nullopt;
    }
    return found;
  }

  // Removes the links that are parts of the circle and adds it. Returns how many were removed;
  // nothing if one link runs all along the circle.
  std::optional<int64_t> Draw(const FoundCircle& found) {
    const auto size = static_cast<double>(found.points.size());
    const Beside beside = LinksBeside(found);
    if (beside.num_drawn < kMinDrawnShare * size) return std::nullopt;  // a better one took them
    for (const auto& [id, count] : beside.links) {
      const DrawingLink& link = editor_.link(id);
      if (link.node0 == link.node1 && count > kWholeShare * size) return std::nullopt;
    }
    std::set<NodeId> nodes;
    std::vector<LinkId> parts;
    for (const auto& [id, count] : beside.links) {
      const auto [begin, end] = RestOf(found, id);
      const DrawingLink& link = editor_.link(id);
      if (begin == 0 && end == link.size()) continue;
      nodes.insert({link.node0, link.node1});
      if (end - begin < 2 || ArcPx(link, begin, end - 1) <= (1 - kPartShare) * LengthPx(link) ||
          ArcPx(link, begin, end - 1) < 3) {
        parts.push_back(id);
      } else {
        editor_.CutTo(id, begin, end);
        cut_.insert(id);
      }
    }
    const LinkId circle = AddCircle(found);
    for (const LinkId id : parts) {
      editor_.Remove(id);
    }
    Attach(found, nodes, circle);
    return static_cast<int64_t>(parts.size());
  }

  // The points of a link that remain when both ends are cut back as far as they run along a circle.
  std::pair<int, int> RestOf(const FoundCircle& found, LinkId id) const {
    const DrawingLink& link = editor_.link(id);
    const auto is_beside = [&](int k) {
      const Vector3d& position = link.points_in_world[k];
      if (MissOf(found.circle, std::array{position}) > kRimPx * found.footprint) return false;
      const Vector3d tangent = found.circle.Normal().cross(position - found.circle.center);
      return LineAngleBetween(TangentAt(link, k), tangent) < kRimRad;
    };
    int begin = 0;
    int end = link.size();
    while (begin < end && is_beside(begin)) ++begin;
    while (begin < end && is_beside(end - 1)) --end;
    return {begin, end};
  }

  LinkId AddCircle(const FoundCircle& found) {
    DrawingLink link;
    for (size_t k = 0; k <= found.points.size(); ++k) {
      const CirclePoint& point = found.points[k % found.points.size()];
      link.points_in_world.push_back(point.position);
      LinkVertex vertex;
      vertex.footprint = found.footprint;
      vertex.support = point.support;
      vertex.information = input_.Information(point.support, point.position);
      link.sigma.push_back(SigmaAcross(vertex.information, found.footprint));
      for (const EdgelRef& ref : point.support) link.supporting_views.push_back(ref.view);
      link.vertices.push_back(std::move(vertex));
    }
    SortUnique(&link.supporting_views);
    return editor_.Add(std::move(link));
  }

  // Takes the nodes at which other links left the parts to the circle.
  void Attach(const FoundCircle& found, const std::set<NodeId>& nodes, LinkId circle) {
    std::map<int, std::vector<NodeId>> by_point;
    for (const NodeId node : nodes) {
      if (!editor_.IsNode(node)) continue;
      const Vector3d& position = editor_.node(node).position_in_world;
      if (MissOf(found.circle, std::array{position}) > 2 * found.footprint) continue;
      const Vector3d offset = position - found.circle.center;
      const double angle =
          std::atan2(found.circle.y_axis.dot(offset), found.circle.x_axis.dot(offset));
      const auto size = static_cast<int>(found.points.size());
      const int k = static_cast<int>(std::lround(angle / (2 * M_PI) * size)) + size;
      by_point[k % size].push_back(node);
    }
    if (by_point.empty()) return;
    const auto [first, first_nodes] = *by_point.begin();
    const NodeId anchor = editor_.Split(circle, first);
    for (const NodeId node : first_nodes) editor_.MoveEnds(node, anchor);
    for (auto item = by_point.rbegin(); item->first != first; ++item) {
      const NodeId cut = editor_.Split(circle, item->first - first);
      for (const NodeId node : item->second) editor_.MoveEnds(node, cut);
    }
  }

  const TopologyInput& input_;
  GraphEditor& editor_;
  const Places places_;
  const SpatialIndex index_;
  std::set<LinkId> cut_;  // their points are no longer those of places_
};

}  // namespace

CircleCounts CompleteCircles(const TopologyInput& input, const RunContext& context,
                             GraphEditor* editor) {
  return CircleFinder(input, editor).Run(context);
}

}  // namespace limn
