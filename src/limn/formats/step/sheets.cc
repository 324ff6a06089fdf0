// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "limn/geometry/polygon_triangulation.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/polyline_position.h"

namespace limn {
namespace {

// A place on a loop: an edge, and how far along it, as a position on its link or on its bridge.
struct LoopPlace {
  size_t edge = 0;
  double position = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

double BeginOf(const FaceEdge& edge) { return edge.IsBridge() ? 0 : edge.from; }
double EndOf(const FaceEdge& edge) {
  return edge.IsBridge() ? static_cast<double>(edge.bridge.size()) - 1 : edge.to;
}

// From the edge's points (CourseOf) to positions: those of the ends, and the indices in between.
double PositionOf(const FaceEdge& edge, size_t num_points, const PolylinePoint& on_course) {
  const double begin = BeginOf(edge), end = EndOf(edge);
  const double sign = begin < end ? 1 : -1;
  const double first_inner = begin < end ? std::floor(begin) + 1 : std::ceil(begin) - 1;
  const auto position_of = [&](int point) {
    if (point == 0) return begin;
    if (point == static_cast<int>(num_points) - 1) return end;
    return first_inner + sign * (point - 1);
  };
  const double before = position_of(on_course.segment), after = position_of(on_course.segment + 1);
  return before + on_course.t * (after - before);
}

LoopPlace NearestPlace(const DrawingGraph& graph, const FaceLoop& loop,
                       const Eigen::Vector3d& point) {
  LoopPlace nearest;
  double least = -1;
  for (size_t e = 0; e < loop.size(); ++e) {
    const std::vector<Eigen::Vector3d> course = CourseOf(graph, loop[e]);
    const PolylinePoint candidate = ClosestPoint(course, point);
    if (least >= 0 && candidate.squared_distance >= least) continue;
    least = candidate.squared_distance;
    nearest = {e, PositionOf(loop[e], course.size(), candidate), candidate.position};
  }
  return nearest;
}

// At a share of the loop's length, from its beginning.
LoopPlace PlaceAtShare(const DrawingGraph& graph, const FaceLoop& loop, double share) {
  double length = 0;
  for (const FaceEdge& edge : loop) length += Length(CourseOf(graph, edge));
  double rest = share * length;
  for (size_t e = 0; e < loop.size(); ++e) {
    const std::vector<Eigen::Vector3d> course = CourseOf(graph, loop[e]);
    const std::vector<double> lengths = CumulativeLength(course);
    if (rest > lengths.back() && e + 1 < loop.size()) {
      rest -= lengths.back();
      continue;
    }
    PolylinePoint place;
    while (place.segment + 2 < static_cast<int>(course.size()) &&
           lengths[place.segment + 1] <= rest) {
      ++place.segment;
    }
    const double segment_length = lengths[place.segment + 1] - lengths[place.segment];
    place.t = segment_length > 0
                  ? std::clamp((rest - lengths[place.segment]) / segment_length, 0.0, 1.0)
                  : 0;
    place.position = (1 - place.t) * course[place.segment] + place.t * course[place.segment + 1];
    return {e, PositionOf(loop[e], course.size(), place), place.position};
  }
  return {};
}

// Part of an edge; of a bridge, from one position on it to another, ascending.
FaceEdge PartOfEdge(const FaceEdge& edge, double from, double to) {
  FaceEdge part = edge;
  if (!edge.IsBridge()) {
    part.from = from;
    part.to = to;
    return part;
  }
  DrawingLink as_link;
  as_link.points_in_world = edge.bridge;
  part.bridge = {PointAtPosition(as_link.points_in_world, from)};
  for (int i = static_cast<int>(std::floor(from)) + 1; i < to; ++i) {
    part.bridge.push_back(edge.bridge[i]);
  }
  part.bridge.push_back(PointAtPosition(as_link.points_in_world, to));
  return part;
}

bool IsBefore(const FaceLoop& loop, const LoopPlace& a, const LoopPlace& b) {
  if (a.edge != b.edge) return a.edge < b.edge;
  const bool forward = BeginOf(loop[a.edge]) < EndOf(loop[a.edge]);
  return forward ? a.position < b.position : a.position > b.position;
}

// The part of a closed loop from one place to another, around its beginning if need be.
FaceLoop PartOfLoop(const FaceLoop& loop, const LoopPlace& from, const LoopPlace& to) {
  FaceLoop part;
  const auto add = [&](size_t edge, double begin, double end) {
    if (begin != end) part.push_back(PartOfEdge(loop[edge], begin, end));
  };
  if (from.edge == to.edge && IsBefore(loop, from, to)) {
    add(from.edge, from.position, to.position);
    return part;
  }
  add(from.edge, from.position, EndOf(loop[from.edge]));
  for (size_t e = (from.edge + 1) % loop.size(); e != to.edge; e = (e + 1) % loop.size()) {
    add(e, BeginOf(loop[e]), EndOf(loop[e]));
  }
  add(to.edge, BeginOf(loop[to.edge]), to.position);
  return part;
}

FaceLoop Reversed(FaceLoop loop) {
  std::reverse(loop.begin(), loop.end());
  for (FaceEdge& edge : loop) {
    std::swap(edge.from, edge.to);
    std::reverse(edge.bridge.begin(), edge.bridge.end());
  }
  return loop;
}

// The circle that all edges of a loop are on.
std::optional<CircularArc> CircleOf(const DrawingGraph& graph, const FaceLoop& loop) {
  constexpr double kSame = 1e-6;
  std::optional<CircularArc> circle;
  for (const FaceEdge& edge : loop) {
    if (edge.IsBridge() || !graph.links[edge.link].primitive) return std::nullopt;
    const auto* arc = std::get_if<CircularArc>(&graph.links[edge.link].primitive->shape);
    if (!arc) return std::nullopt;
    if (!circle) circle = *arc;
    if ((arc->center - circle->center).norm() > kSame * circle->radius ||
        std::abs(arc->radius - circle->radius) > kSame * circle->radius) {
      return std::nullopt;
    }
  }
  return circle;
}

class RailCutter {
 public:
  RailCutter(const DrawingGraph& graph, const FaceLoop& rail, const FaceLoop& other)
      : graph_(graph), rail_(rail), other_(other), circle_(CircleOf(graph, other)) {}

  // Four sides of each half; none if the cuts meet.
  std::vector<std::vector<FaceLoop>> Halves() const {
    const LoopPlace a0 = PlaceAtShare(graph_, rail_, 0), a1 = PlaceAtShare(graph_, rail_, 0.5);
    const LoopPlace b0 = OnOther(a0.point), b1 = OnOther(a1.point);
    if (b0.edge == b1.edge && b0.position == b1.position) return {};
    const LoopPlace between = OnOther(PlaceAtShare(graph_, rail_, 0.25).point);
    // Whether the other rail passes `between` on its way from b0 to b1.
    const bool same_way = IsOnTheWay(b0, between, b1);
    const FaceLoop first =
        same_way ? Reversed(PartOfLoop(other_, b0, b1)) : PartOfLoop(other_, b1, b0);
    const FaceLoop second =
        same_way ? Reversed(PartOfLoop(other_, b1, b0)) : PartOfLoop(other_, b0, b1);
    return {{PartOfLoop(rail_, a0, a1), Line(a1, b1), first, Line(b0, a0)},
            {PartOfLoop(rail_, a1, a0), Line(a0, b0), second, Line(b1, a1)}};
  }

 private:
  LoopPlace OnOther(const Eigen::Vector3d& point) const {
    if (!circle_) return NearestPlace(graph_, other_, point);
    const Eigen::Vector3d normal = circle_->Normal();
    Eigen::Vector3d radial = point - circle_->center;
    radial -= normal.dot(radial) * normal;
    return NearestPlace(graph_, other_, circle_->center + circle_->radius * radial.normalized());
  }

  bool IsOnTheWay(const LoopPlace& from, const LoopPlace& place, const LoopPlace& to) const {
    const bool after = IsBefore(other_, from, place), before = IsBefore(other_, place, to);
    return IsBefore(other_, from, to) ? after && before : after || before;
  }

  static FaceLoop Line(const LoopPlace& from, const LoopPlace& to) {
    FaceEdge edge;
    edge.bridge = {from.point, to.point};
    return {edge};
  }

  const DrawingGraph& graph_;
  const FaceLoop& rail_;
  const FaceLoop& other_;
  std::optional<CircularArc> circle_;
};

std::vector<FaceLoop> SidesOf(const DrawingFace& face) {
  const FaceLoop& loop = face.loops.front();
  std::vector<FaceLoop> sides;
  for (size_t s = 0; s < face.side_starts.size(); ++s) {
    const auto end =
        s + 1 < face.side_starts.size() ? loop.begin() + face.side_starts[s + 1] : loop.end();
    sides.emplace_back(loop.begin() + face.side_starts[s], end);
  }
  return sides;
}

// Loops of vertices around triangles, each in the direction of the triangles; none if these do not
// close.
std::vector<std::vector<int>> OutlinesOf(const std::vector<std::array<int, 3>>& triangles) {
  std::set<std::pair<int, int>> sides;
  for (const auto& [i, j, k] : triangles) {
    for (const auto& side : {std::pair(i, j), std::pair(j, k), std::pair(k, i)}) {
      if (sides.erase({side.second, side.first}) == 0) sides.insert(side);
    }
  }
  std::map<int, int> next(sides.begin(), sides.end());
  if (next.size() != sides.size()) return {};
  std::vector<std::vector<int>> outlines;
  while (!next.empty()) {
    std::vector<int>& outline = outlines.emplace_back();
    const int first = next.begin()->first;
    for (auto at = next.begin(); at != next.end(); at = next.find(outline.back())) {
      outline.push_back(at->second);
      next.erase(at);
    }
    if (outline.back() != first) return {};
  }
  return outlines;
}

}  // namespace

std::vector<Eigen::Vector3d> CourseOf(const DrawingGraph& graph, const FaceEdge& edge) {
  if (edge.IsBridge()) return edge.bridge;
  const DrawingLink& link = graph.links[edge.link];
  const auto [low, high] = std::minmax(edge.from, edge.to);
  std::vector<Eigen::Vector3d> course = {PointAtPosition(link.points_in_world, low)};
  for (int i = static_cast<int>(std::floor(low)) + 1; i < high; ++i) {
    course.push_back(link.points_in_world[i]);
  }
  course.push_back(PointAtPosition(link.points_in_world, high));
  if (edge.from > edge.to) std::reverse(course.begin(), course.end());
  return course;
}

std::vector<StepSheet> SheetsOf(const DrawingGraph& graph) {
  std::vector<StepSheet> sheets;
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    const DrawingFace& face = graph.faces[id];
    const int f = static_cast<int>(id);
    if (face.surface == FaceSurface::kPlane) {
      sheets.push_back({f, face.loops});
    } else if (face.loops.size() == 1) {
      sheets.push_back({f, SidesOf(face)});
    } else {
      for (auto& sides : RailCutter(graph, face.loops[0], face.loops[1]).Halves()) {
        sheets.push_back({f, std::move(sides)});
      }
    }
  }
  return sheets;
}

StepSheet SheetApart(const DrawingGraph& graph, int face_id) {
  const DrawingFace& face = graph.faces[face_id];
  std::vector<std::pair<double, FaceLoop>> loops;  // with twice their areas
  for (const std::vector<int>& outline : OutlinesOf(face.triangles)) {
    std::vector<Eigen::Vector3d> corners;
    for (const int vertex : outline) corners.push_back(face.vertices[vertex]);
    auto& [area, loop] = loops.emplace_back(PolygonAreaVector(corners).norm(), FaceLoop());
    for (size_t c = 0; c < corners.size(); ++c) {
      loop.push_back({-1, 0, 0, {corners[c], corners[(c + 1) % corners.size()]}});
    }
  }
  // The outer border first.
  std::ranges::stable_sort(loops, std::greater<>(), [](const auto& loop) { return loop.first; });
  StepSheet sheet = {face_id, {}};
  for (auto& [area, loop] : loops) sheet.sides.push_back(std::move(loop));
  return sheet;
}

}  // namespace limn
