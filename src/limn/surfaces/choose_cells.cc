// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/choose_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "limn/visibility/face_surface.h"
#include "limn/visibility/render_depth.h"

namespace limn {
namespace {

// A place this far behind other faces is hidden, px.
constexpr double kHiddenPx = 3;
// Faces of two planes are copies if they are within this many plane tolerances, and normals within
// 20 degrees.
constexpr double kCopyTolerances = 2;
constexpr double kMinCopyCosine = 0.94;

double Balance(const FaceEvidence& evidence, const SurfaceOptions& options) {
  return options.prior_evidence + evidence.hidden + evidence.seen_through;
}

// Whether a view sees most of the places of a candidate that it can judge: half, or a quarter of
// a bent one.
bool SeesMost(const FaceCandidate& candidate, const std::vector<PlaceSight>& sights) {
  const auto num_seen = std::ranges::count(sights, PlaceSight::kSeen);
  const auto num_hidden = std::ranges::count(sights, PlaceSight::kHidden);
  return num_seen > 0 && (candidate.flat ? 2 : 4) * num_seen >= num_seen + num_hidden;
}

// Share of the places that enough views see.
double SeenShare(const FaceCandidate& candidate, const PlaceSights& sights,
                 const SurfaceOptions& options) {
  const size_t num_places = candidate.places.size();
  int num_seen = 0;
  for (size_t p = 0; p < num_places; ++p) {
    const auto num_views = std::ranges::count_if(
        sights, [&](const auto& of_view) { return of_view.second[p] == PlaceSight::kSeen; });
    num_seen += num_views >= options.min_views;
  }
  return num_places == 0 ? 0 : static_cast<double>(num_seen) / static_cast<double>(num_places);
}

bool IsSeen(const FaceCandidate& candidate, const PlaceSights& sights,
            const SurfaceOptions& options) {
  const auto num_views = std::ranges::count_if(
      sights, [&](const auto& of_view) { return SeesMost(candidate, of_view.second); });
  const double share = SeenShare(candidate, sights, options);
  const double min_share = std::max(options.min_seen_share, candidate.min_seen_share);
  return num_views >= options.min_views && share > 0 && share >= min_share;
}

class CellChooser {
 public:
  CellChooser(const std::vector<View>& views, const DrawingGraph& graph,
              const std::vector<PlaneCells>& planes, const std::vector<CellChoice>& cells,
              const SurfaceOptions& options, const RunContext& context)
      : views_(views),
        graph_(graph),
        planes_(planes),
        cells_(cells),
        options_(options),
        context_(context),
        fates_(cells.size(), CellFate::kFace) {}

  std::vector<CellFate> Run() {
    for (size_t c = 0; c < cells_.size(); ++c) {
      if (Balance(cells_[c].evidence, options_) < 0) {
        fates_[c] = CellFate::kSeenThrough;
      } else if (!IsSeen(cells_[c].candidate, cells_[c].evidence.sights, options_)) {
        fates_[c] = CellFate::kUnseen;
      }
    }
    // What hides others may turn out to be hidden itself: then these come back.
    DropHidden();
    DropHidden();
    Spread();
    DropCopies();
    return fates_;
  }

 private:
  bool IsFace(size_t c) const { return fates_[c] == CellFate::kFace; }

  TriangleMesh MeshOfFaces() const {
    TriangleMesh mesh;
    for (size_t c = 0; c < cells_.size(); ++c) {
      const FaceCandidate& candidate = cells_[c].candidate;
      if (IsFace(c)) AddTriangles(candidate.vertices, candidate.triangles, &mesh);
    }
    return mesh;
  }

  // Judges again the cells that are faces or behind faces.
  void DropHidden() {
    const TriangleMesh mesh = MeshOfFaces();
    std::vector<std::vector<std::vector<PlaceSight>>> sights_by(views_.size());
    ParallelFor(context_, "faces before faces", views_.size(), [&](size_t v) {
      const DepthImage depth = RenderDepth(mesh, views_[v], /*scale=*/1);
      sights_by[v].resize(cells_.size());
      for (size_t c = 0; c < cells_.size(); ++c) {
        sights_by[v][c] = UnhiddenIn(static_cast<ViewId>(v), depth, cells_[c]);
      }
    });
    for (size_t c = 0; c < cells_.size(); ++c) {
      if (!IsFace(c) && fates_[c] != CellFate::kBehind) continue;
      PlaceSights unhidden;
      for (const auto& [view, sights] : cells_[c].evidence.sights) {
        unhidden[view] = sights_by[view][c];
      }
      fates_[c] =
          IsSeen(cells_[c].candidate, unhidden, options_) ? CellFate::kFace : CellFate::kBehind;
    }
  }

  // The places of a candidate in a view, hidden where faces are before them.
  std::vector<PlaceSight> UnhiddenIn(ViewId view, const DepthImage& depth,
                                     const CellChoice& choice) const {
    const auto found = choice.evidence.sights.find(view);
    if (found == choice.evidence.sights.end()) return {};
    std::vector<PlaceSight> sights = found->second;
    for (size_t p = 0; p < sights.size(); ++p) {
      if (sights[p] != PlaceSight::kSeen) continue;
      const Eigen::Vector3d in_cam =
          views_[view].cam_from_world * choice.candidate.places[p].position;
      const double tolerance = kHiddenPx * choice.candidate.footprint;
      if (IsBehind(depth, views_[view].camera.Project(in_cam), in_cam.z(), tolerance)) {
        sights[p] = PlaceSight::kHidden;
      }
    }
    return sights;
  }

  // To cells that were unseen, beside faces.
  void Spread() {
    std::vector<std::vector<size_t>> choices_of(planes_.size());
    for (size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].plane >= 0) choices_of[cells_[c].plane].push_back(c);
    }
    for (size_t p = 0; p < planes_.size(); ++p) {
      std::vector<size_t> choice_of(planes_[p].cells.size());
      for (const size_t c : choices_of[p]) choice_of[cells_[c].cell] = c;
      std::vector<int> cell_of = CellOfHalfEdges(planes_[p]);
      for (bool any = true; any;) {
        any = false;
        for (size_t e = 0; e < planes_[p].arrangement.edges.size(); ++e) {
          const int left = cell_of[2 * e], right = cell_of[2 * e + 1];
          if (left < 0 || right < 0 || !IsOnSurface(planes_[p], e)) continue;
          any = SpreadBetween(choice_of[left], choice_of[right]) || any;
        }
      }
    }
  }

  // Planes may be found twice, a little apart, and so are their cells.
  void DropCopies() {
    std::vector<Eigen::AlignedBox3d> boxes(cells_.size());
    for (size_t c = 0; c < cells_.size(); ++c) boxes[c] = BoxAround(cells_[c].candidate);
    for (size_t c = 0; c < cells_.size(); ++c) {
      if (!IsFace(c) || !cells_[c].candidate.flat) continue;
      std::vector<CandidatePlace> places = cells_[c].candidate.places;
      const auto num_places = std::ssize(places);
      for (size_t e = 0; e < c && cells_[e].plane < cells_[c].plane; ++e) {
        if (!IsFace(e) || !cells_[e].candidate.flat || !boxes[e].intersects(boxes[c])) continue;
        std::erase_if(
            places, [&](const CandidatePlace& place) { return IsOn(place, cells_[e].candidate); });
      }
      if (2 * std::ssize(places) < num_places) fates_[c] = CellFate::kCopy;
    }
  }

  // Of what may be a copy of a flat candidate.
  Eigen::AlignedBox3d BoxAround(const FaceCandidate& candidate) const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : candidate.vertices) box.extend(vertex);
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(CopyDistance(candidate));
    return {box.min() - margin, box.max() + margin};
  }
  double CopyDistance(const FaceCandidate& candidate) const {
    return kCopyTolerances * options_.plane_tolerance_px * candidate.footprint;
  }

  // Whether a place is on a flat candidate.
  bool IsOn(const CandidatePlace& place, const FaceCandidate& candidate) const {
    const FlatRegion& flat = *candidate.flat;
    const Eigen::Vector3d normal = flat.frame.Normal();
    const double distance = std::abs(normal.dot(place.position - flat.frame.origin));
    return distance <= CopyDistance(candidate) &&
           std::abs(normal.dot(place.normal)) >= kMinCopyCosine &&
           flat.polygon.Contains(flat.frame.Flat(place.position));
  }

  bool SpreadBetween(size_t a, size_t b) {
    if (IsFace(a) == IsFace(b)) return false;
    const size_t other = IsFace(a) ? b : a;
    if (fates_[other] != CellFate::kUnseen) return false;
    fates_[other] = CellFate::kFace;
    return true;
  }

  static std::vector<int> CellOfHalfEdges(const PlaneCells& plane) {
    std::vector<int> cell_of(2 * plane.arrangement.edges.size(), -1);
    for (size_t c = 0; c < plane.cells.size(); ++c) {
      for (const auto& loop : plane.cells[c].loops) {
        for (const HalfEdge half : loop) cell_of[half] = static_cast<int>(c);
      }
    }
    return cell_of;
  }

  // Whether there is the same surface on both sides of an edge.
  bool IsOnSurface(const PlaneCells& plane, size_t edge) const {
    const LinkId link = plane.strokes.strokes[plane.arrangement.edges[edge].run.stroke].link;
    if (link < 0) return true;
    const LinkKind kind = graph_.links[link].kind;
    return kind == LinkKind::kPaint || kind == LinkKind::kShadow;
  }

  const std::vector<View>& views_;
  const DrawingGraph& graph_;
  const std::vector<PlaneCells>& planes_;
  const std::vector<CellChoice>& cells_;
  const SurfaceOptions& options_;
  const RunContext& context_;
  std::vector<CellFate> fates_;
};

}  // namespace

std::vector<CellFate> ChooseCells(const std::vector<View>& views, const DrawingGraph& graph,
                                  const std::vector<PlaneCells>& planes,
                                  const std::vector<CellChoice>& cells,
                                  const SurfaceOptions& options, const RunContext& context) {
  return CellChooser(views, graph, planes, cells, options, context).Run();
}

double ConfidenceOf(const CellChoice& choice, const SurfaceOptions& options) {
  const double odds = std::exp(std::min(Balance(choice.evidence, options), 50.0));
  // A face that has spread from others was not seen itself.
  const double seen_share = SeenShare(choice.candidate, choice.evidence.sights, options);
  return std::max(seen_share, 0.5) * odds / (1 + odds);
}

std::vector<ViewId> ViewsOf(const CellChoice& choice) {
  std::vector<ViewId> views;
  for (const auto& [view, sights] : choice.evidence.sights) {
    if (SeesMost(choice.candidate, sights)) views.push_back(view);
  }
  return views;
}

}  // namespace limn
