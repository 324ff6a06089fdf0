// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/faces.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Geometry>

#include "limn/util/name_table.h"

namespace limn {
namespace {

constexpr NameTable<FaceSurface, kNumFaceSurfaces> kFaceSurfaces = {{"plane", "ruled", "patch"}};

bool IsOnLink(double position, int num_points) {
  return position >= 0 && position <= num_points - 1;
}

bool AreFinite(const std::vector<Eigen::Vector3d>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Eigen::Vector3d& point) { return point.allFinite(); });
}

std::string ProblemOf(const FaceEdge& edge, const std::vector<int>& num_points) {
  if (edge.IsBridge()) {
    if (edge.bridge.size() < 2) return "a bridge has fewer than two points";
    return AreFinite(edge.bridge) ? "" : "a point of a bridge is not finite";
  }
  if (!edge.bridge.empty()) return "an edge is both a link and a bridge";
  if (edge.link >= static_cast<int>(num_points.size()))
    return "an edge is on a link that does not exist";
  const int n = num_points[edge.link];
  const bool is_on_link = IsOnLink(edge.from, n) && IsOnLink(edge.to, n) && edge.from != edge.to;
  return is_on_link ? "" : "an edge is not on its link";
}

// Whether a surface can have this many loops, and sides if it has only one.
bool HasRightLoops(const DrawingFace& face) {
  const size_t num_sides = face.side_starts.size();
  switch (face.surface) {
    case FaceSurface::kPlane:
      return num_sides == 0;
    case FaceSurface::kRuled:
      return face.loops.size() == 2 ? num_sides == 0 : face.loops.size() == 1 && num_sides == 4;
    case FaceSurface::kPatch:
      return face.loops.size() == 1 && num_sides >= 2;
  }
  return false;
}

bool HasRightSides(const DrawingFace& face) {
  const std::vector<int>& starts = face.side_starts;
  if (starts.empty()) return true;
  const bool ascend =
      std::adjacent_find(starts.begin(), starts.end(), std::greater_equal<>()) == starts.end();
  return ascend && starts.front() == 0 && starts.back() < static_cast<int>(face.loops[0].size());
}

bool AreOfVertices(const std::array<int, 3>& triangle, size_t num_vertices) {
  return std::all_of(triangle.begin(), triangle.end(), [&](int vertex) {
    return vertex >= 0 && vertex < static_cast<int>(num_vertices);
  });
}

}  // namespace

const char* FaceSurfaceName(FaceSurface surface) { return kFaceSurfaces.Of(surface); }

std::optional<FaceSurface> FaceSurfaceNamed(const std::string& name) {
  return kFaceSurfaces.Find(name);
}

std::string Validate(const DrawingFace& face, const std::vector<int>& num_points) {
  if (face.loops.empty()) return "it has no border";
  for (const FaceLoop& loop : face.loops) {
    if (loop.empty()) return "a loop has no edges";
    for (const FaceEdge& edge : loop) {
      std::string problem = ProblemOf(edge, num_points);
      if (!problem.empty()) return problem;
    }
  }
  if (!HasRightLoops(face) || !HasRightSides(face)) {
    return "its surface cannot have such loops and sides";
  }
  if (!(std::abs(face.normal.norm() - 1) < 1e-6) || !std::isfinite(face.offset)) {
    return "its plane has no normal or no offset";
  }
  if (!AreFinite(face.vertices)) return "a vertex is not finite";
  for (const auto& triangle : face.triangles) {
    if (!AreOfVertices(triangle, face.vertices.size())) return "a corner is not a vertex";
  }
  if (!(face.confidence >= 0 && face.confidence <= 1)) return "its confidence is not from 0 to 1";
  return "";
}

DrawingFace Transformed(DrawingFace face, const Similarity3d& similarity) {
  for (FaceLoop& loop : face.loops) {
    for (FaceEdge& edge : loop) {
      for (Eigen::Vector3d& point : edge.bridge) point = similarity * point;
    }
  }
  for (Eigen::Vector3d& vertex : face.vertices) vertex = similarity * vertex;
  face.normal = similarity.rotation * face.normal;
  face.offset = similarity.scale * face.offset + face.normal.dot(similarity.translation);
  return face;
}

bool RenameLinks(const std::vector<int>& new_link, DrawingFace* face) {
  for (FaceLoop& loop : face->loops) {
    for (FaceEdge& edge : loop) {
      if (edge.IsBridge()) continue;
      if (new_link[edge.link] < 0) return false;
      edge.link = new_link[edge.link];
    }
  }
  return true;
}

double AreaOf(const DrawingFace& face) {
  double area = 0;
  for (const auto& [a, b, c] : face.triangles) {
    const Eigen::Vector3d& corner = face.vertices[a];
    area += (face.vertices[b] - corner).cross(face.vertices[c] - corner).norm() / 2;
  }
  return area;
}

}  // namespace limn
