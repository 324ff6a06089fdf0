// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/plane_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/geometry/polygon_with_holes.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Points nearer than this become one, px.
constexpr double kWeldPx = 0.25;

FaceEdge EdgeOf(const PlaneStrokes& strokes, const StrokeRun& run) {
  const PlaneStroke& stroke = strokes.strokes[run.stroke];
  if (stroke.link >= 0) {
    return {stroke.link, PositionOnLink(stroke, run.from), PositionOnLink(stroke, run.to), {}};
  }
  FaceEdge edge;
  for (const double position : {run.from, run.to}) {
    edge.bridge.push_back(strokes.frame.InSpace(PointOn(stroke, position)));
  }
  return edge;
}

DrawingFace FaceOf(const PlaneCells& plane, const ArrangementCell& cell) {
  const PlaneFrame& frame = plane.strokes.frame;
  DrawingFace face;
  face.normal = frame.Normal();
  face.offset = face.normal.dot(frame.origin);
  for (const std::vector<HalfEdge>& half_edges : cell.loops) {
    FaceLoop loop;
    for (const StrokeRun& run : RunsAlong(plane.arrangement, half_edges)) {
      FaceEdge edge = EdgeOf(plane.strokes, run);
      // A part across the link, between two ends that touch it, has no length along it.
      if (edge.IsBridge() || edge.from != edge.to) loop.push_back(std::move(edge));
    }
    face.loops.push_back(std::move(loop));
  }
  for (const Polyline2d& outline : cell.polygon.outlines) {
    for (const Eigen::Vector2d& corner : outline) face.vertices.push_back(frame.InSpace(corner));
  }
  face.triangles = Triangulate(cell.polygon);
  return face;
}

}  // namespace

double WidthOf(const Polygon2d& polygon) {
  double perimeter = 0;
  for (const Polyline2d& outline : polygon.outlines) perimeter += Perimeter(outline);
  return perimeter > 0 ? 2 * polygon.Area() / perimeter : 0;
}

PlaneCells CellsBetween(PlaneStrokes strokes) {
  PlaneCells result;
  result.strokes = std::move(strokes);
  std::vector<Polyline2d> lines;
  for (const PlaneStroke& stroke : result.strokes.strokes) lines.push_back(stroke.points);
  result.arrangement = Arrange(lines, kWeldPx * result.strokes.footprint);
  result.cells =
      FindCells(result.arrangement, std::vector<uint8_t>(result.arrangement.edges.size(), 1));
  return result;
}

PlaneCells FindPlaneCells(const FacePlane& plane, const std::vector<FaceLink>& links,
                          const DrawingGraph& graph, const SurfaceOptions& options) {
  PlaneCells result = CellsBetween(MakeStrokes(plane, links, graph, options));
  const double min_width = options.min_width_px * result.strokes.footprint;
  std::erase_if(result.cells,
                [&](const ArrangementCell& cell) { return WidthOf(cell.polygon) < min_width; });
  return result;
}

std::vector<MadeFace> MakeFaces(const PlaneCells& plane, const std::vector<uint8_t>& is_face) {
  const size_t num_edges = plane.arrangement.edges.size();
  std::vector<int> cell_of(2 * num_edges, -1);  // per half-edge: the cell on its left if a face
  for (size_t c = 0; c < plane.cells.size(); ++c) {
    if (!is_face[c]) continue;
    for (const auto& loop : plane.cells[c].loops) {
      for (const HalfEdge half : loop) cell_of[half] = static_cast<int>(c);
    }
  }
  // Cells on both sides of an edge that is not used are one.
  UnionFind merged(plane.cells.size());
  std::vector<uint8_t> use_edge(num_edges, 0);
  for (size_t e = 0; e < num_edges; ++e) {
    const int left = cell_of[2 * e], right = cell_of[2 * e + 1];
    const int stroke = plane.arrangement.edges[e].run.stroke;
    const bool is_link = plane.strokes.strokes[stroke].link >= 0;
    use_edge[e] = (left < 0) != (right < 0) || (left >= 0 && is_link);
    if (left >= 0 && right >= 0 && !is_link) merged.Union(left, right);
  }
  std::vector<MadeFace> made;
  for (const ArrangementCell& cell : FindCells(plane.arrangement, use_edge)) {
    const int first = cell_of[cell.loops[0][0]];
    if (first < 0) continue;
    MadeFace face = {FaceOf(plane, cell), {}};
    for (size_t c = 0; c < plane.cells.size(); ++c) {
      if (is_face[c] && merged.Find(static_cast<int>(c)) == merged.Find(first)) {
        face.cells.push_back(static_cast<int>(c));
      }
    }
    made.push_back(std::move(face));
  }
  return made;
}

bool HasBridges(const DrawingFace& face) {
  return std::ranges::any_of(face.loops, [](const FaceLoop& loop) {
    return std::ranges::any_of(loop, &FaceEdge::IsBridge);
  });
}

}  // namespace limn
