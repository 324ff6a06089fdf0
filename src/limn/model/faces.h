// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/similarity3.h"

namespace limn {

// Surfaces bounded by links of a drawing (limn/surfaces/). Positions in world units.

enum class FaceSurface : uint8_t {
  kPlane,  // of any number of loops: the outer border, then holes
  kRuled,  // straight lines from one rail to another: two closed loops, or two sides of one loop
  kPatch,  // bends between all sides of one loop
};
constexpr int kNumFaceSurfaces = 3;

// "plane", "ruled", "patch".
const char* FaceSurfaceName(FaceSurface surface);
// Nothing if there is no such surface.
std::optional<FaceSurface> FaceSurfaceNamed(const std::string& name);

// A part of a face's border: a part of a link, or a bridge where no link was found.
struct FaceEdge {
  int link = -1;
  // Where it begins and ends along the link: index of a point plus a fraction of the way to the
  // next. from > to is against the link's direction.
  double from = 0;
  double to = 0;
  // The course of a bridge, at least two points; empty if there is a link.
  std::vector<Eigen::Vector3d> bridge;

  bool IsBridge() const { return link < 0; }
};

// Each edge begins where the one before ends, the first where the last ends.
using FaceLoop = std::vector<FaceEdge>;

struct DrawingFace {
  FaceSurface surface = FaceSurface::kPlane;
  // Outer border first, counterclockwise around the normals, then holes, clockwise. The edges of
  // one loop of a ruled surface and of a patch are grouped in sides.
  std::vector<FaceLoop> loops;
  // First edge of each side of the loop of a ruled surface (four, rails are the first and the
  // third) or a patch, ascending from 0; empty if a ruled surface has two loops, and for planes.
  std::vector<int> side_starts;
  // Of a plane: unit, towards the side that is seen; normal . x = offset.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  // The surface in triangles, counterclockwise seen from the visible side.
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  double confidence = 0;  // 0 to 1
  // Views that see it, ascending.
  std::vector<int> views;
};

// What is wrong with a face; empty if it is valid: links or positions on them out of range (of
// num_points[link] points), bridges of fewer than two points, loops or sides that its surface
// cannot have, numbers that are not finite, a normal that is not a unit vector, triangles with
// vertices that do not exist, a confidence outside [0, 1]. Linear time.
std::string Validate(const DrawingFace& face, const std::vector<int>& num_points);

// Under a change of coordinates.
DrawingFace Transformed(DrawingFace face, const Similarity3d& similarity);

// Gives links new ids; false if a link of the face has none (-1).
bool RenameLinks(const std::vector<int>& new_link, DrawingFace* face);

// Of all triangles, square world units.
double AreaOf(const DrawingFace& face);

}  // namespace limn
