// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/patch_candidates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "limn/geometry/mean_value.h"
#include "limn/geometry/polygon_triangulation.h"
#include "limn/geometry/refine_triangles.h"
#include "limn/surfaces/bent_loops.h"
#include "limn/surfaces/flat_candidates.h"
#include "limn/surfaces/plane_cells.h"

namespace limn {
namespace {

// Most loops that are not flat have false links: outlines of smooth bodies, taken for edges. So
// much of what they surround is not seen.
constexpr double kMinSeenShare = 0.75;
// Edges of the mesh, share of the size of a patch, and how many vertices at most.
constexpr double kMeshShare = 1 / 16.0;
constexpr size_t kMaxVertices = 1000;
// Slopes are differences over this share of its size.
constexpr double kSlopeShare = 1e-3;

// A surface over the plane of a frame, from a border that goes around it once.
class LiftedPatch {
 public:
  LiftedPatch(const PlaneFrame& frame, const Polyline3d& border) : frame_(frame) {
    for (const Eigen::Vector3d& point : border) {
      const Eigen::Vector2d flat = frame.Flat(point);
      if (!border_.empty() && flat == border_.back()) continue;
      border_.push_back(flat);
      heights_.push_back(frame.Normal().dot(point - frame.origin));
      extent_.extend(flat);
    }
    if (border_.front() == border_.back()) {
      border_.pop_back();
      heights_.pop_back();
    }
  }

  double Size() const { return extent_.sizes().maxCoeff(); }
  Eigen::Vector3d At(const Eigen::Vector2d& flat) const {
    return frame_.InSpace(flat) + HeightAt(flat) * frame_.Normal();
  }
  Eigen::Vector3d NormalAt(const Eigen::Vector2d& flat) const {
    const double step = kSlopeShare * Size();
    const Eigen::Vector2d x(step, 0), y(0, step);
    return (At(flat + x) - At(flat - x)).cross(At(flat + y) - At(flat - y)).normalized();
  }

 private:
  double HeightAt(const Eigen::Vector2d& flat) const {
    return MeanValueAt(border_, heights_, flat);
  }

  const PlaneFrame& frame_;
  Polyline2d border_;
  std::vector<double> heights_;
  Eigen::AlignedBox2d extent_;
};

// The frame across the normal of a loop.
PlaneFrame FrameAcross(const Polyline3d& points) {
  const Eigen::Vector3d normal = PolygonAreaVector(points).normalized();
  PlaneFrame frame;
  frame.origin = points.front();
  frame.x_axis = normal.unitOrthogonal();
  frame.y_axis = normal.cross(frame.x_axis);
  return frame;
}

PlaneStroke BridgeBetween(const PlaneFrame& frame, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to) {
  return {-1, {frame.Flat(from), frame.Flat(to)}, {}, {}};
}

// The loop in the plane of a frame, with the region that it surrounds as the only cell; nothing if
// it crosses itself.
std::optional<PlaneCells> CellOf(const BentLoop& loop, const DrawingGraph& graph,
                                 const PlaneFrame& frame) {
  PlaneStrokes strokes;
  strokes.frame = frame;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Polyline3d from = PointsOf({loop[i]}, graph);
    const Polyline3d to = PointsOf({loop[(i + 1) % loop.size()]}, graph);
    strokes.footprint = std::max(strokes.footprint, loop[i].link->footprint);
    strokes.strokes.push_back(MakeStroke(*loop[i].link, graph, frame));
    strokes.strokes.push_back(BridgeBetween(frame, from.back(), to.front()));
  }
  PlaneCells plane = CellsBetween(std::move(strokes));
  if (plane.cells.size() != 1 || plane.cells[0].loops.size() != 1 ||
      plane.cells[0].loops[0].size() != plane.arrangement.edges.size()) {
    return std::nullopt;
  }
  return plane;
}

void SetBorder(const BentLoop& loop, const DrawingGraph& graph, DrawingFace* face) {
  face->surface = FaceSurface::kPatch;
  face->loops.resize(1);
  FaceLoop& border = face->loops[0];
  for (size_t i = 0; i < loop.size(); ++i) {
    const LoopStep& step = loop[i];
    const LoopStep& next = loop[(i + 1) % loop.size()];
    face->side_starts.push_back(static_cast<int>(border.size()));
    border.push_back(WholeLink(graph, step.link->link, step.reversed));
    const Eigen::Vector3d from = PointsOf({step}, graph).back();
    const Eigen::Vector3d to = PointsOf({next}, graph).front();
    if (from != to) border.push_back({-1, 0, 0, {from, to}});
  }
}

std::optional<BentCandidate> MakePatch(const BentLoop& loop, const DrawingGraph& graph,
                                       const SurfaceOptions& options) {
  const Polyline3d points = PointsOf(loop, graph);
  const PlaneFrame frame = FrameAcross(points);
  const auto plane = CellOf(loop, graph, frame);
  if (!plane ||
      WidthOf(plane->cells[0].polygon) < options.min_width_px * plane->strokes.footprint) {
    return std::nullopt;
  }
  const LiftedPatch patch(frame, points);
  BentCandidate made;
  FaceCandidate& candidate = made.candidate;
  candidate = FlatCandidate(*plane, plane->cells[0]);
  candidate.flat.reset();
  candidate.min_seen_share = kMinSeenShare;
  for (CandidatePlace& place : candidate.places) {
    const Eigen::Vector2d flat = frame.Flat(place.position);
    place.position = patch.At(flat);
    place.normal = patch.NormalAt(flat);
  }
  Polyline2d vertices = plane->cells[0].polygon.outlines[0];
  RefineTriangles(kMeshShare * patch.Size(), kMaxVertices, &vertices, &candidate.triangles);
  candidate.vertices.clear();
  for (const Eigen::Vector2d& vertex : vertices) candidate.vertices.push_back(patch.At(vertex));
  SetBorder(loop, graph, &made.face);
  made.face.vertices = candidate.vertices;
  made.face.triangles = candidate.triangles;
  return made;
}

}  // namespace

std::vector<BentCandidate> FindPatchCandidates(const std::vector<FaceLink>& links,
                                               const DrawingGraph& graph,
                                               const SurfaceOptions& options) {
  std::vector<BentCandidate> candidates;
  for (const BentLoop& loop : FindBentLoops(links, graph, options)) {
    if (auto patch = MakePatch(loop, graph, options)) candidates.push_back(std::move(*patch));
  }
  return candidates;
}

}  // namespace limn
