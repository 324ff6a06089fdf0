// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/coinciding_places.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/spatial_index.h"
#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Places coincide up to this distance, px.
constexpr double kMissPx = 1;
// The point of a link nearest to a crossing is at most this far from it, px: points are about 1 px
// apart.
constexpr double kHalfStepPx = 0.6;

// A node that links share, or a point in the middle of a link.
struct Place {
  NodeId node = -1;
  LinkId link = -1;
  int index = -1;

  auto operator<=>(const Place&) const = default;
};

// The links at a place and their directions: towards a node, both ways in the middle of a link.
struct Arms {
  std::vector<Vector3d> directions;
  std::set<LinkId> links;
};

// Two places that may be one.
struct Coincidence {
  double distance_px = 0;  // of the points
  Place a, b;              // a < b

  auto operator<=>(const Coincidence&) const = default;
};

// The links as one sees them from their places, before any edit.
class PlaceView {
 public:
  explicit PlaceView(const MeetingTask& task)
      : task_(task),
        editor_(*task.editor),
        min_parting_rad_(task.options.min_junction_angle_deg * kDeg) {
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      const DrawingLink& link = editor_.link(id);
      std::vector<double>& arcs = arc_px_.emplace_back();
      for (int k = 0; k < static_cast<int>(link.vertices.size()); ++k) {
        arcs.push_back(k == 0 ? 0 : arcs.back() + ArcPx(link, k - 1, k));
      }
    }
  }

  // All pairs of places that links pass each other at, nearest first.
  std::vector<Coincidence> Find(const Places& points) const {
    const SpatialIndex index(points.position);
    std::set<Coincidence> found;
    std::vector<SpatialIndex::Neighbor> near;
    for (size_t i = 0; i < points.position.size(); ++i) {
      const auto& [link_a, at_a] = points.point[i];
      const Place a = PlaceOf(link_a, at_a);
      if (!MayMeet(a)) continue;
      const double footprint_a = editor_.link(link_a).vertices[at_a].footprint;
      index.FindWithin(points.position[i], (kMissPx + 2 * kHalfStepPx) * footprint_a, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const auto& [link_b, at_b] = points.point[neighbor.index];
        const Place b = PlaceOf(link_b, at_b);
        if (link_a == link_b || a == b || !MayMeet(b)) continue;
        const double footprint_b = editor_.link(link_b).vertices[at_b].footprint;
        if (!AreNear(a, footprint_a, b, footprint_b)) continue;
        const auto [first, second] = std::minmax(a, b);
        found.insert({2 * std::sqrt(neighbor.squared_distance) / (footprint_a + footprint_b), first,
                      second});
      }
    }
    return {found.begin(), found.end()};
  }

  const Vector3d& PositionOf(const Place& place) const {
    return place.node >= 0 ? editor_.node(place.node).position_in_world
                           : editor_.link(place.link).points_in_world[place.index];
  }

  Arms ArmsAt(const Place& place) const {
    if (place.node < 0) {
      const Vector3d tangent = TangentAt(editor_.link(place.link), place.index);
      return {{tangent, -tangent}, {place.link}};
    }
    Arms arms;
    for (const LinkEnd& end : editor_.node(place.node).incident) {
      arms.directions.push_back(TipOf(editor_.link(end.link), end.end).outward);
      arms.links.insert(end.link);
    }
    return arms;
  }

  // Whether the places have no link in common and no links that run along each other.
  bool Part(const Arms& a, const Arms& b) const {
    const auto is_of_b = [&](LinkId link) { return b.links.contains(link); };
    if (std::ranges::any_of(a.links, is_of_b)) return false;
    return std::ranges::all_of(a.directions, [&](const Vector3d& u) {
      return std::ranges::all_of(
          b.directions, [&](const Vector3d& v) { return AngleBetween(u, v) > min_parting_rad_; });
    });
  }

  // That any link of the one place meets any of the other.
  bool ImagesShow(const Coincidence& at) const {
    const std::vector<FragmentsByView> of_b = FragmentsAt(at.b);
    return std::ranges::any_of(FragmentsAt(at.a), [&](const FragmentsByView& a) {
      return std::ranges::any_of(of_b, [&](const FragmentsByView& b) {
        return ImagesAgree(task_.input, PositionOf(at.a), a, b, task_.options.min_junction_views);
      });
    });
  }

  // Along the link of both places, px.
  double ArcBetween(const Place& a, const Place& b) const {
    const std::vector<double>& arcs = arc_px_[a.link];
    return std::abs(arcs[a.index] - arcs[b.index]);
  }

  // An end that goes on for less behind a crossing overshoots, and is taken back to it.
  double LeastApartPx() const { return task_.reach.overshoot_px; }

 private:
  // The node at an end of a link, else the point.
  Place PlaceOf(LinkId id, int index) const {
    const DrawingLink& link = editor_.link(id);
    if (index == 0) return {link.node0};
    if (index == link.size() - 1) return {link.node1};
    return {-1, id, index};
  }

  bool MayMeet(const Place& place) const {
    if (place.node >= 0) {
      const auto& incident = editor_.node(place.node).incident;
      return incident.size() > 1 && std::ranges::none_of(incident, [&](const LinkEnd& end) {
               const DrawingLink& link = editor_.link(end.link);
               return link.closed || link.vertices.empty();
             });
    }
    const std::vector<double>& arcs = arc_px_[place.link];
    const double arc = arcs[place.index];
    return !editor_.link(place.link).closed && std::min(arc, arcs.back() - arc) >= LeastApartPx();
  }

  // Whether the links pass by each other at these points. In the middle of a link its tangent
  // stands for it.
  bool AreNear(const Place& a, double footprint_a, const Place& b, double footprint_b) const {
    const Vector3d offset = PositionOf(b) - PositionOf(a);
    const double miss = 0.5 * kMissPx * (footprint_a + footprint_b);
    if (a.node >= 0 && b.node >= 0) return offset.norm() <= miss;
    if (a.node >= 0) return IsNearLine(offset, b, miss, footprint_b);
    if (b.node >= 0) return IsNearLine(offset, a, miss, footprint_a);
    const Vector3d u = TangentAt(editor_.link(a.link), a.index);
    const Vector3d v = TangentAt(editor_.link(b.link), b.index);
    if (LineAngleBetween(u, v) <= min_parting_rad_) return false;
    const Vector3d normal = u.cross(v);
    const double square = normal.squaredNorm();
    return std::abs(offset.dot(normal)) <= miss * std::sqrt(square) &&
           std::abs(offset.cross(v).dot(normal)) <= kHalfStepPx * footprint_a * square &&
           std::abs(offset.cross(u).dot(normal)) <= kHalfStepPx * footprint_b * square;
  }

  bool IsNearLine(const Vector3d& offset, const Place& place, double miss, double footprint) const {
    const Vector3d direction = TangentAt(editor_.link(place.link), place.index);
    return offset.cross(direction).norm() <= miss &&
           std::abs(offset.dot(direction)) <= kHalfStepPx * footprint;
  }

  // The fragments of every link of a place.
  std::vector<FragmentsByView> FragmentsAt(const Place& place) const {
    if (place.node < 0) {
      return {FragmentsAround(task_.input, editor_.link(place.link), place.index)};
    }
    std::vector<FragmentsByView> fragments;
    for (const LinkEnd& end : editor_.node(place.node).incident) {
      fragments.push_back(FragmentsAtEnd(task_.input, editor_.link(end.link), end.end));
    }
    return fragments;
  }

  const MeetingTask& task_;
  const GraphEditor& editor_;
  double min_parting_rad_;
  std::vector<std::vector<double>> arc_px_;  // per link, up to each point with a vertex
};

// Which places become one node.
class PlaceGroups {
 public:
  PlaceGroups(const PlaceView& view, size_t num_coincidences)
      : view_(view), sets_(static_cast<int>(2 * num_coincidences)) {}

  // Puts two places into one group, unless links of their groups run along each other or between
  // them, or one is too near to another place on its link. Returns whether it did.
  bool Unite(const Coincidence& at) {
    const auto a = StandIn(at.a);
    const auto b = StandIn(at.b);
    if (!a || !b) return false;
    const int set_a = SetOf(*a);
    const int set_b = SetOf(*b);
    if (set_a >= 0 && set_a == set_b) return false;
    const Arms arms_a = set_a >= 0 ? arms_.at(set_a) : view_.ArmsAt(*a);
    const Arms arms_b = set_b >= 0 ? arms_.at(set_b) : view_.ArmsAt(*b);
    if (!view_.Part(arms_a, arms_b) || !view_.ImagesShow(at)) return false;
    const int member_a = members_.try_emplace(*a, std::ssize(members_)).first->second;
    const int member_b = members_.try_emplace(*b, std::ssize(members_)).first->second;
    sets_.Union(member_a, member_b);
    arms_[sets_.Find(member_a)] = AllOf(arms_a, arms_b);
    return true;
  }

  // Makes the nodes. Links are cut from the back, so that indices before a cut stay valid.
  void Apply(GraphEditor* editor) {
    std::map<int, std::vector<NodeId>> nodes;
    for (auto it = members_.rbegin(); it != members_.rend(); ++it) {
      const auto& [place, member] = *it;
      nodes[sets_.Find(member)].push_back(place.node >= 0 ? place.node
                                                          : editor->Split(place.link, place.index));
    }
    for (const auto& [set, together] : nodes) {
      Vector3d middle = Vector3d::Zero();
      for (const NodeId node : together) middle += editor->node(node).position_in_world;
      const NodeId one = editor->AddNode(middle / static_cast<double>(together.size()));
      for (const NodeId node : together) editor->MoveEnds(node, one);
    }
    editor->Compact();
  }

 private:
  static Arms AllOf(Arms a, const Arms& b) {
    a.directions.insert(a.directions.end(), b.directions.begin(), b.directions.end());
    a.links.insert(b.links.begin(), b.links.end());
    return a;
  }

  // This place, or one of a group that is as near to it as places that coincide. None beside
  // others on the link.
  std::optional<Place> StandIn(const Place& place) const {
    if (place.node >= 0) return place;
    for (auto it = members_.lower_bound({-1, place.link, -1});
         it != members_.end() && it->first.node < 0 && it->first.link == place.link; ++it) {
      const double apart_px = view_.ArcBetween(place, it->first);
      if (apart_px <= kMissPx) return it->first;
      if (apart_px < view_.LeastApartPx()) return std::nullopt;
    }
    return place;
  }

  // The group of a place, -1 if there is none.
  int SetOf(const Place& place) {
    const auto it = members_.find(place);
    return it == members_.end() ? -1 : sets_.Find(it->second);
  }

  const PlaceView& view_;
  std::map<Place, int> members_;
  UnionFind sets_;
  std::map<int, Arms> arms_;  // by group
};

}  // namespace

CoincidenceCounts UniteCoincidingPlaces(const MeetingTask& task) {
  CoincidenceCounts counts;
  const Places points = CollectPlaces(task.editor->graph());
  if (points.position.empty()) return counts;
  const PlaceView view(task);
  const std::vector<Coincidence> found = view.Find(points);
  PlaceGroups groups(view, found.size());
  for (const Coincidence& at : found) {
    if (!groups.Unite(at)) continue;
    const int num_nodes = (at.a.node >= 0) + (at.b.node >= 0);
    ++(num_nodes == 0 ? counts.crossings : num_nodes == 1 ? counts.passed : counts.nodes);
  }
  groups.Apply(task.editor);
  return counts;
}

}  // namespace limn
