// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/ruled_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "limn/geometry/polyline_position.h"

namespace limn {
namespace {

// Axes differ by less than three degrees.
constexpr double kMinAxisCosine = 0.9986;
// Axes and radii differ by less than this, px, and circles are at least this far apart.
constexpr double kMaxAxisShiftPx = 3;
constexpr double kMinApartPx = 4;
// Straight lines of a mesh, this far apart, px, and how many at least and at most.
constexpr double kRulingSpacingPx = 4;
constexpr int kMinRulings = 8, kMaxRulings = 64;
// Places on a surface, and the border around each: rulings to both sides, this share of all away.
constexpr int kNumPlaces = 16;
constexpr double kBorderShare = 0.03;

// A place on each of two links that a straight line of the surface joins.
struct Ruling {
  double a = 0, b = 0;  // positions on the links
};

// Two links of a surface and how it runs.
struct Rails {
  const FaceLink* a = nullptr;
  const FaceLink* b = nullptr;
  bool closed = false;
  // Of open rails: links that join end 0 of a, and end 1, to the ends of b; -1: bridges.
  std::array<LinkId, 2> sides = {-1, -1};
  bool b_is_reversed = false;
  // Moves points of a near those of b, if they are copies of each other.
  std::optional<Eigen::Vector3d> shift;
};

// The position at a share of the length.
double PositionAt(const std::vector<Eigen::Vector3d>& points, double share) {
  const std::vector<double> along = CumulativeLength(points);
  const double length = share * along.back();
  const auto next = std::ranges::upper_bound(along, length);
  const size_t i =
      std::min<size_t>(std::max<std::ptrdiff_t>(next - along.begin(), 1) - 1, points.size() - 2);
  const double step = along[i + 1] - along[i];
  const double t = step > 0 ? (length - along[i]) / step : 0;
  return static_cast<double>(i) + std::clamp(t, 0.0, 1.0);
}

class RailFinder {
 public:
  RailFinder(const std::vector<FaceLink>& links, const DrawingGraph& graph,
             const SurfaceOptions& options)
      : graph_(graph), options_(options), link_of_(graph.links.size(), nullptr) {
    for (const FaceLink& link : links) {
      if (!link.IsStraight(options.plane_tolerance_px)) bent_.push_back(&link);
      link_of_[link.link] = &link;
    }
  }

  std::vector<Rails> Run() const {
    std::vector<Rails> found;
    for (size_t i = 0; i < bent_.size(); ++i) {
      for (size_t j = i + 1; j < bent_.size(); ++j) {
        if (const auto rails = Joined(*bent_[i], *bent_[j])) {
          found.push_back(*rails);
        } else if (const auto coaxial = Coaxial(*bent_[i], *bent_[j])) {
          found.push_back(*coaxial);
        }
      }
    }
    return found;
  }

 private:
  const DrawingLink& Link(const FaceLink& link) const { return graph_.links[link.link]; }

  const CircularArc* ArcOf(const FaceLink& link) const {
    const auto& primitive = Link(link).primitive;
    return primitive ? std::get_if<CircularArc>(&primitive->shape) : nullptr;
  }

  // A straight link between two nodes.
  LinkId StraightBetween(NodeId from, NodeId to) const {
    for (const LinkEnd& end : graph_.nodes[from].incident) {
      const FaceLink* link = link_of_[end.link];
      if (!link || !link->IsStraight(options_.plane_tolerance_px)) continue;
      if (graph_.links[end.link].NodeAt(1 - end.end) == to) return end.link;
    }
    return -1;
  }

  // Whose ends straight links join.
  std::optional<Rails> Joined(const FaceLink& a, const FaceLink& b) const {
    if (Link(a).closed || Link(b).closed) return std::nullopt;
    for (const bool reversed : {false, true}) {
      Rails rails = {&a, &b, false, {-1, -1}, reversed, std::nullopt};
      for (const int end : {0, 1}) {
        rails.sides[end] =
            StraightBetween(Link(a).NodeAt(end), Link(b).NodeAt(reversed ? 1 - end : end));
      }
      if (rails.sides[0] >= 0 && rails.sides[1] >= 0 && rails.sides[0] != rails.sides[1] &&
          !AreFlat(a, b)) {
        return rails;
      }
    }
    return std::nullopt;
  }

  bool AreFlat(const FaceLink& a, const FaceLink& b) const {
    return LiesIn(b, a.normal, a.normal.dot(a.center), 2 * options_.plane_tolerance_px);
  }

  // Circles, or arcs whose ends are beside each other, around one axis with the same radius.
  std::optional<Rails> Coaxial(const FaceLink& a, const FaceLink& b) const {
    const auto shift = AxialShift(a, b);
    if (!shift || Link(a).closed != Link(b).closed || HasBetween(a, b, *shift)) {
      return std::nullopt;
    }
    Rails rails = {&a, &b, Link(a).closed, {-1, -1}, false, shift};
    if (rails.closed) {
      rails.b_is_reversed = RunsAgainst(a, b, *shift);
      return rails;
    }
    const double reach = options_.max_bridge_px * a.footprint;
    for (const bool reversed : {false, true}) {
      const auto& points = Link(b).points_in_world;
      const Eigen::Vector3d& begin = reversed ? points.back() : points.front();
      const Eigen::Vector3d& end = reversed ? points.front() : points.back();
      if ((Link(a).points_in_world.front() + *shift - begin).norm() > reach ||
          (Link(a).points_in_world.back() + *shift - end).norm() > reach) {
        continue;
      }
      rails.b_is_reversed = reversed;
      for (const int side : {0, 1}) {
        rails.sides[side] =
            StraightBetween(Link(a).NodeAt(side), Link(b).NodeAt(reversed ? 1 - side : side));
      }
      return rails;
    }
    return std::nullopt;
  }

  // From the center of a to that of b, along their axis.
  std::optional<Eigen::Vector3d> AxialShift(const FaceLink& a, const FaceLink& b) const {
    const CircularArc *arc_a = ArcOf(a), *arc_b = ArcOf(b);
    if (!arc_a || !arc_b) return std::nullopt;
    const double px = a.footprint;
    const Eigen::Vector3d axis = arc_a->Normal();
    if (std::abs(axis.dot(arc_b->Normal())) < kMinAxisCosine) return std::nullopt;
    if (std::abs(arc_a->radius - arc_b->radius) > kMaxAxisShiftPx * px) return std::nullopt;
    const Eigen::Vector3d offset = arc_b->center - arc_a->center;
    const double along = offset.dot(axis);
    if (std::abs(along) < kMinApartPx * px) return std::nullopt;
    if ((offset - along * axis).norm() > kMaxAxisShiftPx * px) return std::nullopt;
    return offset;
  }

  // Another one between the two along the axis.
  bool HasBetween(const FaceLink& a, const FaceLink& b, const Eigen::Vector3d& shift) const {
    return std::ranges::any_of(bent_, [&](const FaceLink* other) {
      if (other == &a || other == &b || Link(*other).closed != Link(a).closed) return false;
      const auto part = AxialShift(a, *other);
      if (!part) return false;
      const double share = part->dot(shift) / shift.squaredNorm();
      return share > 0 && share < 1;
    });
  }

  bool RunsAgainst(const FaceLink& a, const FaceLink& b, const Eigen::Vector3d& shift) const {
    const auto& points_a = Link(a).points_in_world;
    const auto& points_b = Link(b).points_in_world;
    const Eigen::Vector3d start = points_a[0] + shift;
    const auto at = ClosestPoint(points_b, start);
    const Eigen::Vector3d way_a = points_a[1] - points_a[0];
    return way_a.dot(points_b[at.segment + 1] - points_b[at.segment]) < 0;
  }

  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  std::vector<const FaceLink*> bent_;
  std::vector<const FaceLink*> link_of_;  // per link of the graph
};

std::vector<Ruling> RulingsOf(const Rails& rails, const DrawingGraph& graph) {
  const auto& a = graph.links[rails.a->link].points_in_world;
  const auto& b = graph.links[rails.b->link].points_in_world;
  const double length_px = std::max(rails.a->length_px, rails.b->length_px);
  const int num =
      std::clamp(static_cast<int>(length_px / kRulingSpacingPx), kMinRulings, kMaxRulings);
  std::vector<Ruling> rulings;
  for (int i = 0; i <= num; ++i) {
    const double share = static_cast<double>(i) / num;
    Ruling ruling = {PositionAt(a, share), 0};
    if (rails.closed) {
      const auto at = ClosestPoint(b, PointAtPosition(a, ruling.a) + *rails.shift);
      ruling.b = at.segment + at.t;
    } else {
      ruling.b = PositionAt(b, rails.b_is_reversed ? 1 - share : share);
    }
    rulings.push_back(ruling);
  }
  return rulings;
}

// From an end of a to the end of b beside it, or back.
FaceEdge SideEdge(const Rails& rails, const DrawingGraph& graph, int end, bool from_a) {
  const DrawingLink& a = graph.links[rails.a->link];
  const DrawingLink& b = graph.links[rails.b->link];
  const int end_b = rails.b_is_reversed ? 1 - end : end;
  const LinkId side = rails.sides[end];
  if (side >= 0) {
    const NodeId start = from_a ? a.NodeAt(end) : b.NodeAt(end_b);
    return WholeLink(graph, side, graph.links[side].node0 != start);
  }
  FaceEdge bridge;
  bridge.bridge = {end == 0 ? a.points_in_world.front() : a.points_in_world.back(),
                   end_b == 0 ? b.points_in_world.front() : b.points_in_world.back()};
  if (!from_a) std::ranges::reverse(bridge.bridge);
  return bridge;
}

// Along a, over to b, back along b, back to a.
void SetLoops(const Rails& rails, const DrawingGraph& graph, DrawingFace* face) {
  face->surface = FaceSurface::kRuled;
  const FaceEdge along_a = WholeLink(graph, rails.a->link, false);
  if (rails.closed) {
    face->loops = {{along_a}, {WholeLink(graph, rails.b->link, rails.b_is_reversed)}};
    return;
  }
  face->loops = {{along_a, SideEdge(rails, graph, 1, true),
                  WholeLink(graph, rails.b->link, !rails.b_is_reversed),
                  SideEdge(rails, graph, 0, false)}};
  face->side_starts = {0, 1, 2, 3};
}

BentCandidate MakeCandidate(const Rails& rails, const DrawingGraph& graph) {
  const LinkId link_a = rails.a->link, link_b = rails.b->link;
  const auto& a = graph.links[link_a].points_in_world;
  const auto& b = graph.links[link_b].points_in_world;
  const std::vector<Ruling> rulings = RulingsOf(rails, graph);
  BentCandidate made;
  FaceCandidate& candidate = made.candidate;
  candidate.footprint = std::max(rails.a->footprint, rails.b->footprint);
  for (const Ruling& ruling : rulings) {
    candidate.vertices.push_back(PointAtPosition(a, ruling.a));
    candidate.vertices.push_back(PointAtPosition(b, ruling.b));
  }
  const int last = static_cast<int>(rulings.size()) - 1;
  for (int i = 0; i < last; ++i) {
    candidate.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    candidate.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  const int reach = std::max(1, static_cast<int>(kBorderShare * last));
  for (int p = 0; p < kNumPlaces; ++p) {
    const int i = static_cast<int>((p + 0.5) / kNumPlaces * last);
    CandidatePlace place;
    place.position = (candidate.vertices[2 * i] + candidate.vertices[2 * i + 1]) / 2;
    const Eigen::Vector3d along = candidate.vertices[2 * i + 2] - candidate.vertices[2 * i];
    const Eigen::Vector3d across = candidate.vertices[2 * i + 1] - candidate.vertices[2 * i];
    place.normal = along.cross(across).normalized();
    if (!place.normal.allFinite()) continue;
    for (const int k : {-reach, 0, reach}) {
      const Ruling& at = rulings[std::clamp(i + k, 0, last)];
      place.border.push_back({link_a, at.a});
      place.border.push_back({link_b, at.b});
    }
    place.min_border = static_cast<int>(place.border.size()) - 1;
    candidate.places.push_back(std::move(place));
  }
  SetLoops(rails, graph, &made.face);
  made.face.vertices = candidate.vertices;
  made.face.triangles = candidate.triangles;
  return made;
}

}  // namespace

std::vector<BentCandidate> FindRuledCandidates(const std::vector<FaceLink>& links,
                                               const DrawingGraph& graph,
                                               const SurfaceOptions& options) {
  std::vector<BentCandidate> candidates;
  for (const Rails& rails : RailFinder(links, graph, options).Run()) {
    candidates.push_back(MakeCandidate(rails, graph));
  }
  return candidates;
}

}  // namespace limn
