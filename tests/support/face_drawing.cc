// SPDX-License-Identifier: BSD-3-Clause
#include "support/face_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "limn/geometry/polygon_triangulation.h"

namespace limn::testing {
namespace {

constexpr double kSamplingTolerance = 1e-4;

Eigen::Vector3d OnLink(const DrawingLink& link, double position) {
  const int segment = std::min(static_cast<int>(position), link.size() - 2);
  const double t = position - segment;
  return (1 - t) * link.points_in_world[segment] + t * link.points_in_world[segment + 1];
}

void AppendPoints(const DrawingLink& link, const FaceEdge& edge,
                  std::vector<Eigen::Vector3d>* points) {
  const bool forward = edge.from < edge.to;
  const auto [low, high] = std::minmax(edge.from, edge.to);
  std::vector<Eigen::Vector3d> of_edge = {OnLink(link, low)};
  for (int i = static_cast<int>(low) + 1; i < high; ++i) {
    of_edge.push_back(link.points_in_world[i]);
  }
  of_edge.push_back(OnLink(link, high));
  if (!forward) std::reverse(of_edge.begin(), of_edge.end());
  points->insert(points->end(), of_edge.begin(), of_edge.end());
}

// `count` points at equal distances along a polyline.
std::vector<Eigen::Vector3d> Evenly(const std::vector<Eigen::Vector3d>& points, int count) {
  const std::vector<double> lengths = CumulativeLength(points);
  std::vector<Eigen::Vector3d> even;
  size_t segment = 0;
  for (int k = 0; k < count; ++k) {
    const double at = lengths.back() * k / (count - 1);
    while (segment + 2 < lengths.size() && lengths[segment + 1] < at) ++segment;
    const double t = (at - lengths[segment]) / (lengths[segment + 1] - lengths[segment]);
    even.push_back(points[segment] + t * (points[segment + 1] - points[segment]));
  }
  return even;
}

// Two rows of the same length, triangles between them.
void Strip(const std::vector<Eigen::Vector3d>& row, const std::vector<Eigen::Vector3d>& other,
           DrawingFace* face) {
  const int count = static_cast<int>(row.size());
  face->vertices = row;
  face->vertices.insert(face->vertices.end(), other.begin(), other.end());
  for (int i = 0; i + 1 < count; ++i) {
    face->triangles.push_back({i, i + 1, count + i + 1});
    face->triangles.push_back({i, count + i + 1, count + i});
  }
}

FaceLoop Joined(const std::vector<FaceLoop>& sides, std::vector<int>* starts) {
  FaceLoop loop;
  for (const FaceLoop& side : sides) {
    starts->push_back(static_cast<int>(loop.size()));
    loop.insert(loop.end(), side.begin(), side.end());
  }
  return loop;
}

CircularArc LevelArc(const Eigen::Vector3d& center, double radius, double sweep_rad) {
  CircularArc arc;
  arc.center = center;
  arc.radius = radius;
  arc.sweep_rad = sweep_rad;
  return arc;
}

}  // namespace

NodeId FaceDrawing::NodeAt(const Eigen::Vector3d& position) {
  for (size_t n = 0; n < graph_.nodes.size(); ++n) {
    const double distance = (graph_.nodes[n].position_in_world - position).norm();
    if (distance < 1e-9) return static_cast<NodeId>(n);
  }
  DrawingNode node;
  node.position_in_world = position;
  graph_.nodes.push_back(node);
  return static_cast<NodeId>(graph_.nodes.size()) - 1;
}

LinkId FaceDrawing::AddShape(const CurveShape& shape) {
  DrawingLink link;
  link.points_in_world = SampleShape(shape, kSamplingTolerance);
  link.node0 = NodeAt(link.points_in_world.front());
  link.node1 = NodeAt(link.points_in_world.back());
  link.points_in_world.front() = graph_.nodes[link.node0].position_in_world;
  link.points_in_world.back() = graph_.nodes[link.node1].position_in_world;
  link.closed = link.node0 == link.node1;
  link.sigma.assign(link.points_in_world.size(), 0.001);
  link.supporting_views = {0, 1};
  // Assigning a whole one makes GCC 12 warn of what shapes of other kinds do not have.
  LinkPrimitive& primitive = link.primitive.emplace();
  primitive.shape = shape;
  primitive.rms_px = 0.25;
  primitive.max_px = 0.5;
  graph_.links.push_back(std::move(link));
  return static_cast<LinkId>(graph_.links.size()) - 1;
}

LinkId FaceDrawing::AddLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return AddShape(LineSegment{from, to});
}

FaceEdge FaceDrawing::Whole(LinkId link, bool reversed) const {
  const double last = graph_.links[link].size() - 1;
  return reversed ? Part(link, last, 0) : Part(link, 0, last);
}

FaceEdge FaceDrawing::Part(LinkId link, double from, double to) { return {link, from, to, {}}; }

FaceEdge FaceDrawing::Bridge(std::vector<Eigen::Vector3d> course) {
  FaceEdge edge;
  edge.bridge = std::move(course);
  return edge;
}

FaceLoop FaceDrawing::Loop(const std::vector<LinkId>& links) const {
  FaceLoop loop = {Whole(links.front())};
  NodeId at = graph_.links[links.front()].node1;
  for (size_t i = 1; i < links.size(); ++i) {
    const DrawingLink& link = graph_.links[links[i]];
    const bool reversed = link.node0 != at;
    loop.push_back(Whole(links[i], reversed));
    at = reversed ? link.node0 : link.node1;
  }
  return loop;
}

std::vector<Eigen::Vector3d> FaceDrawing::PointsOf(const FaceLoop& loop) const {
  std::vector<Eigen::Vector3d> points;
  for (const FaceEdge& edge : loop) {
    if (edge.IsBridge()) {
      points.insert(points.end(), edge.bridge.begin(), edge.bridge.end());
    } else {
      AppendPoints(graph_.links[edge.link], edge, &points);
    }
  }
  const auto same = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).norm() < 1e-9;
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

void FaceDrawing::AddPlane(const std::vector<FaceLoop>& loops) {
  DrawingFace face;
  face.loops = loops;
  std::vector<Eigen::Vector3d> corners = PointsOf(loops.front());
  corners.pop_back();
  face.normal = PolygonAreaVector(corners).normalized();
  // Holes are reached along a cut from the first corner to their nearest point.
  for (size_t l = 1; l < loops.size(); ++l) {
    std::vector<Eigen::Vector3d> hole = PointsOf(loops[l]);
    hole.pop_back();
    const auto nearest =
        std::min_element(hole.begin(), hole.end(), [&](const auto& a, const auto& b) {
          return (a - corners.front()).norm() < (b - corners.front()).norm();
        });
    std::rotate(hole.begin(), nearest, hole.end());
    hole.push_back(hole.front());
    corners.push_back(corners.front());
    corners.insert(corners.end(), hole.begin(), hole.end());
  }
  face.offset = face.normal.dot(corners.front());
  face.vertices = corners;
  face.triangles = TriangulatePolygon(corners);
  face.confidence = 0.75;
  face.views = {0, 1};
  graph_.faces.push_back(std::move(face));
}

void FaceDrawing::AddRuled(const FaceLoop& rail, const FaceLoop& other) {
  constexpr int kCount = 65;
  DrawingFace face;
  face.surface = FaceSurface::kRuled;
  face.loops = {rail, other};
  Strip(Evenly(PointsOf(rail), kCount), Evenly(PointsOf(other), kCount), &face);
  face.confidence = 0.5;
  graph_.faces.push_back(std::move(face));
}

void FaceDrawing::AddRuled(const std::vector<FaceLoop>& sides) {
  constexpr int kCount = 65;
  DrawingFace face;
  face.surface = FaceSurface::kRuled;
  face.loops = {Joined(sides, &face.side_starts)};
  std::vector<Eigen::Vector3d> other = Evenly(PointsOf(sides[2]), kCount);
  std::reverse(other.begin(), other.end());
  Strip(Evenly(PointsOf(sides[0]), kCount), other, &face);
  face.confidence = 0.5;
  face.views = {1};
  graph_.faces.push_back(std::move(face));
}

void FaceDrawing::AddPatch(const std::vector<FaceLoop>& sides) {
  DrawingFace face;
  face.surface = FaceSurface::kPatch;
  face.loops = {Joined(sides, &face.side_starts)};
  face.vertices = PointsOf(face.loops.front());
  face.vertices.pop_back();
  const int count = static_cast<int>(face.vertices.size());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : face.vertices) middle += vertex / count;
  face.vertices.push_back(middle);
  for (int i = 0; i < count; ++i) face.triangles.push_back({i, (i + 1) % count, count});
  face.confidence = 1;
  graph_.faces.push_back(std::move(face));
}

DrawingGraph FaceDrawing::graph() const {
  DrawingGraph graph = graph_;
  RebuildIncidence(&graph);
  return graph;
}

DrawingGraph UnitCube() {
  FaceDrawing drawing;
  const auto corner = [](int c) { return Eigen::Vector3d(c & 1, (c >> 1) & 1, c >> 2); };
  std::vector<std::vector<LinkId>> between(8, std::vector<LinkId>(8, -1));
  for (int from = 0; from < 8; ++from) {
    for (const int bit : {1, 2, 4}) {
      if (from & bit) continue;
      between[from][from | bit] = between[from | bit][from] =
          drawing.AddLine(corner(from), corner(from | bit));
    }
  }
  const int squares[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& square : squares) {
    FaceLoop loop;
    for (int i = 0; i < 4; ++i) {
      const int from = square[i], to = square[(i + 1) % 4];
      loop.push_back(drawing.Whole(between[from][to], from > to));
    }
    drawing.AddPlane({loop});
  }
  return drawing.graph();
}

DrawingGraph PlateWithHole() {
  FaceDrawing drawing;
  const LinkId a = drawing.AddLine({0, 0, 1}, {1, 0, 1});
  const LinkId b = drawing.AddLine({2, 0, 1}, {3, 0, 1});
  const LinkId right = drawing.AddLine({3, 0, 1}, {3, 2, 1});
  const LinkId top = drawing.AddLine({0, 2, 1}, {3, 2, 1});
  const LinkId left = drawing.AddLine({0, 0, 1}, {0, 2, 1});
  const LinkId hole = drawing.AddShape(LevelArc({1.5, 1, 1}, 0.5, 2 * std::numbers::pi));
  drawing.AddPlane(
      {{drawing.Whole(a), FaceDrawing::Bridge({{1, 0, 1}, {2, 0, 1}}), drawing.Whole(b),
        drawing.Whole(right), drawing.Whole(top, true), drawing.Whole(left, true)},
       {drawing.Whole(hole, true)}});
  return drawing.graph();
}

DrawingGraph Cylinder(double top_radius) {
  FaceDrawing drawing;
  const LinkId bottom = drawing.AddShape(LevelArc({0, 0, 0}, 1, 2 * std::numbers::pi));
  const LinkId top = drawing.AddShape(LevelArc({0, 0, 2}, top_radius, 2 * std::numbers::pi));
  drawing.AddPlane({{drawing.Whole(bottom, true)}});
  drawing.AddPlane({{drawing.Whole(top)}});
  drawing.AddRuled({drawing.Whole(bottom)}, {drawing.Whole(top)});
  return drawing.graph();
}

DrawingGraph HalfCylinderSide() {
  FaceDrawing drawing;
  const LinkId bottom = drawing.AddShape(LevelArc({0, 0, 0}, 1, std::numbers::pi));
  const LinkId top = drawing.AddShape(LevelArc({0, 0, 2}, 1, std::numbers::pi));
  const LinkId left = drawing.AddLine({-1, 0, 0}, {-1, 0, 2});
  const LinkId right = drawing.AddLine({1, 0, 0}, {1, 0, 2});
  drawing.AddRuled(std::vector<FaceLoop>{{drawing.Whole(bottom)},
                                         {drawing.Whole(left)},
                                         {drawing.Whole(top, true)},
                                         {drawing.Whole(right, true)}});
  return drawing.graph();
}

DrawingGraph PentagonPatch(double sweep_rad) {
  FaceDrawing drawing;
  std::vector<FaceLoop> sides;
  for (int k = 0; k < 5; ++k) {
    const auto corner = [](int i) -> Eigen::Vector3d {
      const double angle = 2 * std::numbers::pi * (i % 5) / 5;
      return {2 * std::cos(angle), 2 * std::sin(angle), 0};
    };
    const Eigen::Vector3d along = (corner(k + 1) - corner(k)).normalized();
    CircularArc arc;
    arc.sweep_rad = sweep_rad;
    arc.radius = (corner(k + 1) - corner(k)).norm() / (2 * std::sin(sweep_rad / 2));
    arc.center = (corner(k) + corner(k + 1)) / 2;
    arc.center.z() -= arc.radius * std::cos(sweep_rad / 2);
    arc.x_axis = (corner(k) - arc.center).normalized();
    arc.y_axis = (along - along.dot(arc.x_axis) * arc.x_axis).normalized();
    sides.push_back({drawing.Whole(drawing.AddShape(arc))});
  }
  drawing.AddPatch(sides);
  return drawing.graph();
}

DrawingGraph TwoSquaresOnOneLine() {
  FaceDrawing drawing;
  const LinkId base = drawing.AddLine({0, 0, 0}, {2, 0, 0});
  const LinkId left = drawing.AddLine({0, 0, 0}, {0, 1, 0});
  const LinkId right = drawing.AddLine({2, 0, 0}, {2, 1, 0});
  const LinkId middle = drawing.AddLine({1, 0, 0}, {1, 1, 0});
  const LinkId back_left = drawing.AddLine({0, 1, 0}, {1, 1, 0});
  const LinkId back_right = drawing.AddLine({1, 1, 0}, {2, 1, 0});
  const double half = (static_cast<double>(drawing.graph().links[base].size()) - 1) / 2;
  drawing.AddPlane({{FaceDrawing::Part(base, 0, half), drawing.Whole(middle),
                     drawing.Whole(back_left, true), drawing.Whole(left, true)}});
  drawing.AddPlane({{FaceDrawing::Part(base, half, 2 * half), drawing.Whole(right),
                     drawing.Whole(back_right, true), drawing.Whole(middle, true)}});
  return drawing.graph();
}

}  // namespace limn::testing
