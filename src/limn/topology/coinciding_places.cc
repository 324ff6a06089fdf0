#include "limn/topology/coinciding_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/spatial_index.h"
#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Places coincide up to this distance, px.
constexpr double kMissPx = 1;
// A link goes on for this long on both sides of a place in its middle, px: an end that overshoots
// is trimmed instead. Places within this distance on a link are one.
constexpr double kGoesOnPx = 4;

// A node that links share, or a place in the middle of a link.
struct Place {
  NodeId node = -1;
  LinkId link = -1;
  int index = -1;

  auto operator<=>(const Place&) const = default;
};

struct Coincidence {
  double distance_px = 0;
  Place a, b;

  auto operator<=>(const Coincidence&) const = default;
};

class CoincidenceFinder {
 public:
  explicit CoincidenceFinder(const MeetingTask& task)
      : task_(task),
        editor_(*task.editor),
        min_parting_rad_(task.options.min_junction_angle_deg * kDeg),
        places_(CollectPlaces(editor_.graph())),
        index_(places_.position) {}

  // Nearest first. Of two links, or a link and a node, none beside a nearer one.
  std::vector<Coincidence> Find() const {
    std::vector<Coincidence> all;
    std::vector<SpatialIndex::Neighbor> near;
    for (size_t i = 0; i < places_.position.size(); ++i) {
      const Place a = PlaceOf(i);
      if (!IsPlace(a)) continue;
      const auto& [link, at] = places_.point[i];
      const double footprint = editor_.link(link).vertices[at].footprint;
      index_.FindWithin(places_.position[i], kMissPx * footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const Place b = PlaceOf(neighbor.index);
        if (!IsPlace(b) || !(a < b) || !Part(a, b)) continue;
        all.push_back({std::sqrt(neighbor.squared_distance) / footprint, a, b});
      }
    }
    std::sort(all.begin(), all.end());
    std::map<std::pair<Place, Place>, std::vector<Coincidence>> nearest;  // of two nodes or links
    std::vector<Coincidence> result;
    for (const Coincidence& next : all) {
      std::vector<Coincidence>& same = nearest[{WithoutIndex(next.a), WithoutIndex(next.b)}];
      const bool is_known = std::ranges::any_of(same, [&](const Coincidence& other) {
        return AreBeside(next.a, other.a) && AreBeside(next.b, other.b);
      });
      if (is_known) continue;
      same.push_back(next);
      if (ImagesShow(next)) result.push_back(next);
    }
    return result;
  }

 private:
  // The node at an end of a link, else the point.
  Place PlaceOf(size_t i) const {
    const auto& [id, at] = places_.point[i];
    const DrawingLink& link = editor_.link(id);
    if (at == 0) return {link.node0};
    if (at == link.size() - 1) return {link.node1};
    return {-1, id, at};
  }

  static Place WithoutIndex(const Place& place) { return {place.node, place.link}; }

  const Eigen::Vector3d& PositionOf(const Place& place) const {
    return place.node >= 0 ? editor_.node(place.node).position_in_world
                           : editor_.link(place.link).points_in_world[place.index];
  }

  bool IsPlace(const Place& place) const {
    if (place.node >= 0) {
      const auto& incident = editor_.node(place.node).incident;
      return incident.size() > 1 && std::ranges::none_of(incident, [&](const LinkEnd& end) {
               const DrawingLink& link = editor_.link(end.link);
               return link.closed || link.vertices.empty();
             });
    }
    const DrawingLink& link = editor_.link(place.link);
    return !link.closed && ArcPx(link, 0, place.index) >= kGoesOnPx &&
           ArcPx(link, place.index, link.size() - 1) >= kGoesOnPx;
  }

  // The directions in which links leave a place, and the links.
  struct Arms {
    std::vector<Eigen::Vector3d> directions;
    std::set<LinkId> links;
  };
  Arms ArmsAt(const Place& place) const {
    if (place.node < 0) {
      const Eigen::Vector3d tangent = TangentAt(editor_.link(place.link), place.index);
      return {{tangent, -tangent}, {place.link}};
    }
    Arms arms;
    for (const LinkEnd& end : editor_.node(place.node).incident) {
      arms.directions.push_back(TipOf(editor_.link(end.link), end.end).outward);
      arms.links.insert(end.link);
    }
    return arms;
  }

  // Do the links of two places part there, and share none?
  bool Part(const Place& a, const Place& b) const {
    const Arms of_a = ArmsAt(a);
    const Arms of_b = ArmsAt(b);
    for (const LinkId link : of_a.links) {
      if (of_b.links.contains(link)) return false;
    }
    for (const Eigen::Vector3d& u : of_a.directions) {
      for (const Eigen::Vector3d& v : of_b.directions) {
        if (!(AngleBetween(u, v) > min_parting_rad_)) return false;
      }
    }
    return true;
  }

  bool AreBeside(const Place& place, const Place& other) const {
    if (place.node >= 0) return true;
    const auto [first, last] = std::minmax(place.index, other.index);
    return ArcPx(editor_.link(place.link), first, last) < kGoesOnPx;
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

  // That any link of the one place meets any of the other.
  bool ImagesShow(const Coincidence& at) const {
    const std::vector<FragmentsByView> of_b = FragmentsAt(at.b);
    return std::ranges::any_of(FragmentsAt(at.a), [&](const FragmentsByView& a) {
      return std::ranges::any_of(of_b, [&](const FragmentsByView& b) {
        return ImagesAgree(task_.input, PositionOf(at.a), a, b, task_.options.min_junction_views);
      });
    });
  }

  const MeetingTask& task_;
  const GraphEditor& editor_;
  double min_parting_rad_;
  Places places_;
  SpatialIndex index_;
};

// The node at each place. Links are cut from the back, so that indices before a cut stay valid;
// places that are near share a node.
std::map<Place, NodeId> CutAt(const std::set<Place>& places, GraphEditor* editor) {
  std::map<Place, NodeId> nodes;
  Place last;
  for (auto it = places.rbegin(); it != places.rend(); ++it) {
    const Place& place = *it;
    NodeId& node = nodes[place];
    if (place.node >= 0) {
      node = place.node;
      continue;
    }
    const bool is_near = last.link == place.link &&
                         ArcPx(editor->link(place.link), place.index, last.index) < kGoesOnPx;
    if (is_near) {
      node = nodes[last];
    } else {
      node = editor->Split(place.link, place.index);
      last = place;
    }
  }
  return nodes;
}

// Makes one of some nodes, in their middle. Not if a link runs between two of them.
void Unite(const std::set<NodeId>& nodes, GraphEditor* editor) {
  std::set<LinkId> links;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const NodeId node : nodes) {
    middle += editor->node(node).position_in_world / static_cast<double>(nodes.size());
    for (const LinkEnd& end : editor->node(node).incident) {
      if (!links.insert(end.link).second) return;
    }
  }
  editor->MoveNode(*nodes.begin(), middle);
  for (auto it = std::next(nodes.begin()); it != nodes.end(); ++it) {
    editor->MoveEnds(*it, *nodes.begin());
  }
}

}  // namespace

CoincidenceCounts UniteCoincidingPlaces(const MeetingTask& task) {
  CoincidenceCounts counts;
  GraphEditor* editor = task.editor;
  if (CollectPlaces(editor->graph()).position.empty()) return counts;
  const std::vector<Coincidence> found = CoincidenceFinder(task).Find();
  std::set<Place> places;
  for (const Coincidence& at : found) {
    places.insert({at.a, at.b});
    const int num_nodes = (at.a.node >= 0) + (at.b.node >= 0);
    ++(num_nodes == 0 ? counts.crossings : num_nodes == 1 ? counts.passed : counts.nodes);
  }
  const std::map<Place, NodeId> node_at = CutAt(places, editor);
  UnionFind sets(static_cast<int>(editor->graph().nodes.size()));
  for (const Coincidence& at : found) sets.Union(node_at.at(at.a), node_at.at(at.b));
  std::map<NodeId, std::set<NodeId>> groups;
  for (const auto& [place, node] : node_at) groups[sets.Find(node)].insert(node);
  for (const auto& [first, group] : groups) {
    if (group.size() > 1) Unite(group, editor);
  }
  editor->Compact();
  return counts;
}

}  // namespace limn
