// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/border_vertices.h"

#include <algorithm>
#include <limits>
#include <set>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "limn/geometry/polyline.h"
#include "limn/geometry/polyline_position.h"

namespace limn {
namespace {

// Onto the planes as nearly as moves of at most `max_move` permit; onto one, or between several
// that are nearly one, of at most `max_projection`.
Eigen::Vector3d MoveOntoPlanes(const DrawingGraph& graph, const std::set<int>& planes,
                               const Eigen::Vector3d& position, double max_move,
                               double max_projection) {
  constexpr double kLeastSines[] = {0.1, 0.3, 0.7};
  Eigen::MatrixXd normals(planes.size(), 3);
  Eigen::VectorXd distances(planes.size());
  int row = 0;
  for (const int f : planes) {
    const DrawingFace& face = graph.faces[f];
    normals.row(row) = face.normal.transpose();
    distances[row++] = face.offset - face.normal.dot(position);
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(normals, Eigen::ComputeThinU | Eigen::ComputeThinV);
  for (const double sine : kLeastSines) {
    svd.setThreshold(sine);
    const Eigen::Vector3d move = svd.solve(distances);
    if (move.norm() <= (svd.rank() == 1 ? max_projection : max_move)) return move;
  }
  return Eigen::Vector3d::Zero();
}

std::vector<double> SizesOf(const std::vector<DrawingFace>& faces) {
  std::vector<double> sizes;
  for (const DrawingFace& face : faces) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : face.vertices) box.extend(vertex);
    sizes.push_back(box.diagonal().norm());
  }
  return sizes;
}

}  // namespace

Eigen::Vector3d PlaceOnCurve(const DrawingGraph& graph, int link_id, double position) {
  const DrawingLink& link = graph.links[link_id];
  const Eigen::Vector3d point = PointAtPosition(link.points_in_world, position);
  if (!link.primitive) return point;
  if (const auto* arc = std::get_if<CircularArc>(&link.primitive->shape)) {
    const Eigen::Vector3d normal = arc->Normal();
    const Eigen::Vector3d from_center = point - arc->center;
    const Eigen::Vector3d radial = from_center - normal.dot(from_center) * normal;
    return arc->center + arc->radius * radial.normalized();
  }
  if (const auto* line = std::get_if<LineSegment>(&link.primitive->shape)) {
    const Eigen::Vector3d along = (line->end - line->start).normalized();
    return line->start + along.dot(point - line->start) * along;
  }
  return point;
}

Eigen::Vector3d PlaceOfNode(const DrawingGraph& graph, const DrawingNode& node) {
  if (node.kind != NodeKind::kLoopAnchor && node.Degree() > 1) return node.position_in_world;
  const LinkEnd& first = node.incident.front();
  return PlaceOnCurve(graph, first.link, first.end == 0 ? 0 : graph.links[first.link].size() - 1);
}

void FitVerticesToPlanes(const DrawingGraph& graph, FaceBorders* borders) {
  constexpr double kMaxMoveShare = 0.2, kMaxProjectionRel = 0.1;
  const std::vector<double> sizes = SizesOf(graph.faces);
  std::vector<std::set<int>> planes(borders->vertices.size());
  std::vector<double> least_length(borders->vertices.size(), -1);
  for (const BorderEdge& edge : borders->edges) {
    const double length = Length(edge.course);
    for (const int vertex : {edge.start, edge.end}) {
      planes[vertex].insert(edge.planes.begin(), edge.planes.end());
      double& least = least_length[vertex];
      least = least < 0 ? length : std::min(least, length);
    }
  }
  for (size_t v = 0; v < planes.size(); ++v) {
    if (planes[v].empty()) continue;
    double least_size = std::numeric_limits<double>::max();
    for (const int f : planes[v]) least_size = std::min(least_size, sizes[f]);
    Eigen::Vector3d& position = borders->vertices[v];
    position += MoveOntoPlanes(graph, planes[v], position, kMaxMoveShare * least_length[v],
                               kMaxProjectionRel * least_size);
  }
}

}  // namespace limn
