// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/flat_candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "limn/geometry/polygon_with_holes.h"

namespace limn {
namespace {

constexpr int kNumPlaces = 24;
constexpr int kNumDirections = 16;
// The grid is at most so fine, of the size of the region: slivers have too little to see.
constexpr double kMinGridShare = 1 / 256.0;

// Places on a grid inside a polygon.
std::vector<Eigen::Vector2d> GridInside(const Polygon2d& polygon) {
  Eigen::AlignedBox2d extent;
  for (const Eigen::Vector2d& corner : polygon.outlines[0]) extent.extend(corner);
  std::vector<Eigen::Vector2d> places;
  const double min_step = kMinGridShare * extent.sizes().maxCoeff();
  double step = std::max(std::sqrt(polygon.Area() / kNumPlaces), min_step);
  // A thin region may be between the places of a coarse grid.
  for (int round = 0; round < 4 && places.empty() && step >= min_step; ++round, step /= 2) {
    const Eigen::Vector2d start = extent.min() + Eigen::Vector2d::Constant(step / 2);
    for (double y = start.y(); y < extent.max().y(); y += step) {
      for (double x = start.x(); x < extent.max().x(); x += step) {
        if (polygon.Contains({x, y})) places.emplace_back(x, y);
      }
    }
  }
  return places;
}

// Per side of the outlines, the part of a stroke along it.
std::vector<std::vector<StrokeRun>> SidesOf(const PlaneCells& plane, const ArrangementCell& cell) {
  std::vector<std::vector<StrokeRun>> sides;
  for (const auto& loop : cell.loops) {
    sides.emplace_back();
    for (const HalfEdge half : loop) {
      StrokeRun side = plane.arrangement.edges[half / 2].run;
      if (half % 2 == 1) std::swap(side.from, side.to);
      sides.back().push_back(side);
    }
  }
  return sides;
}

}  // namespace

FaceCandidate FlatCandidate(const PlaneCells& plane, const ArrangementCell& cell) {
  const PlaneFrame& frame = plane.strokes.frame;
  FaceCandidate candidate;
  candidate.footprint = plane.strokes.footprint;
  candidate.flat = {frame, cell.polygon};
  for (const Polyline2d& outline : cell.polygon.outlines) {
    for (const Eigen::Vector2d& corner : outline) {
      candidate.vertices.push_back(frame.InSpace(corner));
    }
  }
  candidate.triangles = Triangulate(cell.polygon);
  const std::vector<std::vector<StrokeRun>> sides = SidesOf(plane, cell);
  for (const Eigen::Vector2d& flat : GridInside(cell.polygon)) {
    CandidatePlace place = {frame.InSpace(flat), frame.Normal(), {}, kNumDirections / 2};
    for (int d = 0; d < kNumDirections; ++d) {
      const double angle = 2 * M_PI * (d + 0.5) / kNumDirections;
      const OutlinePlace hit = cell.polygon.FirstCrossing(flat, {std::cos(angle), std::sin(angle)});
      if (hit.loop < 0) continue;
      const StrokeRun& run = sides[hit.loop][hit.corner];
      const PlaneStroke& stroke = plane.strokes.strokes[run.stroke];
      if (stroke.link < 0) continue;
      const double position = run.from + hit.t * (run.to - run.from);
      place.border.push_back({stroke.link, PositionOnLink(stroke, position)});
    }
    candidate.places.push_back(std::move(place));
  }
  return candidate;
}

}  // namespace limn
