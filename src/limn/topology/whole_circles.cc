// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/whole_circles.h"

#include <algorithm>
#include <array>
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
#include "limn/util/angles.h"
#include "limn/util/map_items.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Radius of a circle, px.
constexpr double kMinRadiusPx = 2;
constexpr double kMaxRadiusPx = 250;
// A link suggests a circle that it is this near to if it turns by this much; so do two links whose
// ends are this near to each other, which may be chords of a small one.
constexpr double kMinTurnRad = 60 * kDeg;
constexpr double kMaxMissPx = 2;
constexpr double kMaxChordsRadiusPx = 30;
constexpr double kMeetPx = 4;
// Links run along a circle up to this distance and angle.
constexpr double kRimPx = 1.2;
constexpr double kRimRad = 35 * kDeg;
// The least share of a circle along which links run, the least that images show, and the longest
// part that they do not show.
constexpr double kMinDrawnShare = 0.4;
constexpr double kMinShownShare = 0.8;
constexpr double kMaxGapRad = 50 * kDeg;
// Views that show a point, and how near their edgels must be.
constexpr size_t kMinRimViews = 3;
constexpr SupportGate kShownGate = {1.0, 1.0, 20 * kDeg};
// How far a circle may be off the links that it replaces, px: the root of the difference of their
// mean squared distances from their edgels. Squares with round corners and the like are farther
// off.
constexpr double kMaxOffPx = 0.28;
// A circle is drawn already if one loop runs along this share of it.
constexpr double kWholeShare = 0.9;
// A link is part of a circle if no more than this remains of it, px.
constexpr double kMinRestPx = 6;
// Nodes this near to a circle are taken to it, px.
constexpr double kTakenPx = 2;

struct Candidate {
  CircularArc circle;
  double footprint = 0;
  std::vector<ViewId> views;  // that show the links it comes from
};

struct FoundCircle {
  CircularArc circle;
  double footprint = 0;
  std::vector<CirclePoint> points;
  size_t num_edgels = 0;
};

// The links that run along a circle, with the number of its points at which they do.
struct LinksAlong {
  std::map<LinkId, int> count;
  int num_drawn = 0;  // points with a link
};

struct MeanSquare {
  double sum = 0;
  int count = 0;

  double Get() const { return count > 0 ? sum / count : 0; }
};

double MeanFootprint(const DrawingLink& link) {
  double sum = 0;
  for (const LinkVertex& vertex : link.vertices) sum += vertex.footprint;
  return sum / static_cast<double>(link.vertices.size());
}

bool IsFitted(const DrawingLink& link) {
  return std::ranges::any_of(link.vertices,
                             [](const LinkVertex& vertex) { return !vertex.support.empty(); });
}

// Whether images show enough of a circle.
bool IsShown(const std::vector<CirclePoint>& points) {
  const size_t size = points.size();
  size_t num_shown = 0;
  size_t gap = 0;
  size_t longest_gap = 0;
  for (size_t k = 0; k < 2 * size; ++k) {  // twice around: a gap may go over the end
    const bool shown = points[k % size].support.size() >= kMinRimViews;
    gap = shown ? 0 : gap + 1;
    longest_gap = std::max(longest_gap, gap);
    num_shown += shown;
  }
  const auto share = [&](size_t count) { return static_cast<double>(count) / size; };
  return share(num_shown) >= 2 * kMinShownShare && share(longest_gap) * 2 * M_PI <= kMaxGapRad;
}

class CircleCompletion {
 public:
  CircleCompletion(const TopologyInput& input, GraphEditor* editor)
      : input_(input), editor_(*editor) {}

  CircleCounts Run(const RunContext& context) {
    CircleCounts counts;
    for (const FoundCircle& circle : Find(context)) {
      const std::optional<int64_t> num_parts = Draw(circle);
      if (!num_parts) continue;
      ++counts.added;
      counts.replaced += *num_parts;
    }
    editor_.Compact();
    return counts;
  }

 private:
  // Most edgels first.
  std::vector<FoundCircle> Find(const RunContext& context) const {
    const std::vector<Candidate> candidates = Candidates();
    const auto of_candidate = MapItems(context, "circles", candidates.size(),
                                       [&](size_t c) { return CircleOf(candidates[c]); });
    std::vector<FoundCircle> circles;
    for (const auto& circle : of_candidate) {
      if (circle) circles.push_back(*circle);
    }
    std::ranges::stable_sort(circles, std::greater<>(), &FoundCircle::num_edgels);
    return circles;
  }

  std::vector<Candidate> Candidates() const {
    std::vector<LinkId> links;
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (!editor_.link(id).closed && IsFitted(editor_.link(id))) links.push_back(id);
    }
    std::vector<Candidate> candidates;
    const auto add = [&](std::span<const LinkId> ids, double max_radius_px) {
      if (auto found = CandidateOf(ids, max_radius_px)) candidates.push_back(std::move(*found));
    };
    for (const LinkId id : links) add(std::array{id}, kMaxRadiusPx);
    for (const auto& [a, b] : Meeting(links)) add(std::array{a, b}, kMaxChordsRadiusPx);
    return candidates;
  }

  // The circle through the points of links.
  std::optional<Candidate> CandidateOf(std::span<const LinkId> ids, double max_radius_px) const {
    Candidate candidate;
    std::vector<Vector3d> points;
    double length = 0;
    for (const LinkId id : ids) {
      const DrawingLink& link = editor_.link(id);
      points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
      length += Length(link.points_in_world);
      candidate.footprint += MeanFootprint(link) / static_cast<double>(ids.size());
      for (const LinkVertex& vertex : link.vertices) {
        for (const EdgelRef& ref : vertex.support) candidate.views.push_back(ref.view);
      }
    }
    SortUnique(&candidate.views);
    const auto circle = CircleThrough(points);
    if (!circle || length < kMinTurnRad * circle->radius) return std::nullopt;
    const double radius_px = circle->radius / candidate.footprint;
    if (radius_px < kMinRadiusPx || radius_px > max_radius_px) return std::nullopt;
    const auto is_off = [&](const Vector3d& point) {
      return DistanceFromCircle(*circle, point) > kMaxMissPx * candidate.footprint;
    };
    if (std::ranges::any_of(points, is_off)) return std::nullopt;
    candidate.circle = *circle;
    return candidate;
  }

  // Pairs of links with ends that are near to each other.
  std::set<std::pair<LinkId, LinkId>> Meeting(const std::vector<LinkId>& links) const {
    std::vector<Vector3d> ends;
    for (const LinkId id : links) {
      for (const int end : {0, 1}) ends.push_back(EndPoint(editor_.link(id), end));
    }
    const SpatialIndex index(ends);
    std::vector<SpatialIndex::Neighbor> near;
    std::set<std::pair<LinkId, LinkId>> pairs;
    for (size_t e = 0; e < ends.size(); ++e) {
      const LinkId id = links[e / 2];
      const double footprint = TipOf(editor_.link(id), static_cast<int>(e % 2)).footprint;
      index.FindWithin(ends[e], kMeetPx * footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const LinkId other = links[neighbor.index / 2];
        if (other != id) pairs.insert(std::minmax(id, other));
      }
    }
    return pairs;
  }

  std::optional<FoundCircle> CircleOf(const Candidate& candidate) const {
    FoundCircle found;
    found.footprint = candidate.footprint;
    found.circle =
        FitCircleToEdgels(input_, candidate.circle, candidate.footprint, candidate.views);
    const double radius_px = found.circle.radius / found.footprint;
    if (radius_px < kMinRadiusPx || radius_px > kMaxRadiusPx) return std::nullopt;
    found.points =
        LookAlongCircle(input_, found.circle, found.footprint, candidate.views, kShownGate);
    if (!IsShown(found.points)) return std::nullopt;
    const LinksAlong along = FindLinksAlong(found);
    if (!IsDrawn(found, along) || IsOff(found, along)) return std::nullopt;
    for (const CirclePoint& point : found.points) found.num_edgels += point.support.size();
    return found;
  }

  LinksAlong FindLinksAlong(const FoundCircle& found) const {
    LinksAlong along;
    std::set<int> drawn;
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (!editor_.IsLink(id) || !IsFitted(editor_.link(id))) continue;
      std::set<int> by_link;
      for (int k = 0; k < editor_.link(id).size(); ++k) {
        if (!RunsAlong(found, editor_.link(id), k)) continue;
        const double place = PlaceOf(found, editor_.link(id).points_in_world[k]);
        for (const double at : {std::floor(place), std::ceil(place)}) {
          by_link.insert(static_cast<int>(at) % static_cast<int>(found.points.size()));
        }
      }
      if (by_link.empty()) continue;
      along.count[id] = static_cast<int>(by_link.size());
      drawn.merge(by_link);
    }
    along.num_drawn = static_cast<int>(drawn.size());
    return along;
  }

  static bool IsNear(const FoundCircle& found, const Vector3d& point, double within_px = kRimPx) {
    return DistanceFromCircle(found.circle, point) <= within_px * found.footprint;
  }

  static bool RunsAlong(const FoundCircle& found, const DrawingLink& link, int k) {
    const Vector3d& point = link.points_in_world[k];
    if (!IsNear(found, point)) return false;
    const Vector3d tangent = found.circle.Normal().cross(point - found.circle.center);
    return LineAngleBetween(TangentAt(link, k), tangent) < kRimRad;
  }

  // Where a place is among the points of a circle.
  static double PlaceOf(const FoundCircle& found, const Vector3d& point) {
    const double turns = AngleOn(found.circle, point) / (2 * M_PI);
    return (turns < 0 ? turns + 1 : turns) * static_cast<double>(found.points.size());
  }

  static bool IsDrawn(const FoundCircle& found, const LinksAlong& along) {
    return along.num_drawn >= kMinDrawnShare * static_cast<double>(found.points.size());
  }

  // Whether a circle explains the edgels worse than what is drawn along it.
  bool IsOff(const FoundCircle& found, const LinksAlong& along) const {
    MeanSquare of_circle;
    for (const CirclePoint& point : found.points) AddResiduals(point, &of_circle);
    MeanSquare of_links;
    for (const auto& [id, count] : along.count) {
      const DrawingLink& link = editor_.link(id);
      for (int k = 0; k < link.size(); ++k) {
        const Vector3d& position = link.points_in_world[k];
        if (!IsNear(found, position)) continue;
        AddResiduals({position, {}, link.vertices[k].support}, &of_links);
      }
    }
    return of_circle.Get() - of_links.Get() > kMaxOffPx * kMaxOffPx;
  }

  void AddResiduals(const CirclePoint& point, MeanSquare* mean) const {
    for (const EdgelRef& ref : point.support) {
      const auto residual = input_.Residual(ref, point.position);
      if (!residual) continue;
      mean->sum += residual->residual_px * residual->residual_px;
      ++mean->count;
    }
  }

  // Adds a circle in the place of the links that are parts of it. Returns their number; nothing if
  // the circle is drawn whole, or others have taken the links along it.
  std::optional<int64_t> Draw(const FoundCircle& found) {
    const LinksAlong along = FindLinksAlong(found);
    if (!IsDrawn(found, along) || IsWhole(found, along) || IsAdded(found)) return std::nullopt;
    added_.push_back(found);
    std::set<NodeId> nodes;
    std::vector<LinkId> parts;
    for (const auto& [id, count] : along.count) {
      const DrawingLink& link = editor_.link(id);
      const auto [begin, end] = RestOf(found, link);
      const bool is_part = end - begin < 2 || ArcPx(link, begin, end - 1) <= kMinRestPx;
      const bool is_cut = begin > 0 || end < link.size();
      if (!is_part && (!is_cut || link.closed)) continue;
      nodes.insert({link.node0, link.node1});
      if (is_part) {
        parts.push_back(id);
      } else {
        editor_.CutTo(id, begin, end);
      }
    }
    const LinkId circle = editor_.Add(LinkOf(found));
    for (const LinkId id : parts) editor_.Unify(circle, id);
    RemoveBetween(found, nodes);
    Attach(found, nodes, circle);
    return std::ssize(parts);
  }

  bool IsWhole(const FoundCircle& found, const LinksAlong& along) const {
    return std::ranges::any_of(along.count, [&](const auto& item) {
      const DrawingLink& link = editor_.link(item.first);
      return link.node0 == link.node1 &&
             item.second > kWholeShare * static_cast<double>(found.points.size());
    });
  }

  // Whether it is a circle that was added, which other links may have cut since.
  bool IsAdded(const FoundCircle& found) const {
    return std::ranges::any_of(added_, [&](const FoundCircle& added) {
      const auto is_near = [&](const CirclePoint& point) { return IsNear(added, point.position); };
      return 2 * std::ranges::count_if(found.points, is_near) > std::ssize(found.points);
    });
  }

  // The points [begin, end) of a link that remain when both ends are cut back as far as they are
  // near a circle, in any direction: chords turn at their ends.
  static std::pair<int, int> RestOf(const FoundCircle& found, const DrawingLink& link) {
    int begin = 0;
    int end = link.size();
    while (begin < end && IsNear(found, link.points_in_world[begin])) ++begin;
    while (begin < end && IsNear(found, link.points_in_world[end - 1])) --end;
    return {begin, end};
  }

  // Links between the nodes of parts that do not leave the circle would run back along it.
  void RemoveBetween(const FoundCircle& found, const std::set<NodeId>& nodes) {
    std::set<LinkId> between;
    for (const NodeId node : nodes) {
      for (const LinkEnd& end : editor_.node(node).incident) {
        const DrawingLink& link = editor_.link(end.link);
        const bool stays = std::ranges::all_of(link.points_in_world, [&](const Vector3d& point) {
          return IsNear(found, point, kTakenPx);
        });
        if (stays && nodes.contains(editor_.NodeAt({end.link, 1 - end.end}))) {
          between.insert(end.link);
        }
      }
    }
    for (const LinkId id : between) editor_.Remove(id);
  }

  DrawingLink LinkOf(const FoundCircle& found) const {
    DrawingLink link;
    for (const CirclePoint& point : found.points) {
      const Eigen::Matrix3d information = input_.Information(point.support, point.position);
      link.points_in_world.push_back(point.position);
      link.sigma.push_back(SigmaAcross(information, found.footprint));
      link.vertices.push_back({information, found.footprint, 0, point.support, {}});
      for (const EdgelRef& ref : point.support) link.supporting_views.push_back(ref.view);
    }
    link.points_in_world.push_back(link.points_in_world.front());
    link.sigma.push_back(link.sigma.front());
    link.vertices.push_back(Bare(link.vertices.front()));
    SortUnique(&link.supporting_views);
    return link;
  }

  // Takes the nodes at which other links leave the circle to it.
  void Attach(const FoundCircle& found, const std::set<NodeId>& nodes, LinkId circle) {
    std::map<int, std::vector<NodeId>> by_point;
    for (const NodeId node : nodes) {
      if (!editor_.IsNode(node)) continue;
      const Vector3d& position = editor_.node(node).position_in_world;
      if (!IsNear(found, position, kTakenPx)) continue;
      const int k = static_cast<int>(std::lround(PlaceOf(found, position)));
      by_point[k % static_cast<int>(found.points.size())].push_back(node);
    }
    if (by_point.empty()) return;
    // The first cut only rotates the loop to begin there. Of the others the last comes first, so
    // that those before it are still on the same link.
    const int first = by_point.begin()->first;
    TakeNodes(by_point.begin()->second, editor_.Split(circle, first));
    by_point.erase(by_point.begin());
    for (auto cut = by_point.rbegin(); cut != by_point.rend(); ++cut) {
      TakeNodes(cut->second, editor_.Split(circle, cut->first - first));
    }
  }

  void TakeNodes(const std::vector<NodeId>& nodes, NodeId to) {
    for (const NodeId node : nodes) editor_.MoveEnds(node, to);
  }

  const TopologyInput& input_;
  GraphEditor& editor_;
  std::vector<FoundCircle> added_;
};

}  // namespace

CircleCounts CompleteCircles(const TopologyInput& input, const RunContext& context,
                             GraphEditor* editor) {
  return CircleCompletion(input, editor).Run(context);
}

}  // namespace limn
