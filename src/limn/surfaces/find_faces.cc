#include "limn/surfaces/find_faces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace limn {
namespace {

FaceCandidate CandidateOf(const PlaneCells& plane, const ArrangementCell& cell) {
  FaceCandidate candidate = {plane.strokes.frame, plane.strokes.footprint, cell.polygon, {}};
  for (const auto& loop : cell.loops) {
    std::vector<LinkRun> sides;
    for (const HalfEdge half : loop) {
      LinkRun side = OnLink(plane.strokes, plane.arrangement.edges[half / 2].run);
      if (half % 2 == 1) std::swap(side.from, side.to);
      sides.push_back(side);
    }
    candidate.sides.push_back(std::move(sides));
  }
  return candidate;
}

// How sure it is that there is a surface, 0 to 1.
double ConfidenceOf(const FaceEvidence& evidence, const SurfaceOptions& options) {
  const double odds = std::exp(std::min(evidence.occlusion + options.prior_evidence, 100.0));
  return evidence.seen_share * odds / (1 + odds);
}

bool IsSeenThrough(const FaceEvidence& evidence, const SurfaceOptions& options) {
  return evidence.occlusion + options.prior_evidence < 0;
}

// Turns a face to the side that most of its views are on.
void TurnToViews(const std::vector<View>& views, DrawingFace* face) {
  int balance = 0;
  for (const ViewId view : face->views) {
    balance += face->normal.dot(views[view].CenterInWorld()) > face->offset ? 1 : -1;
  }
  if (balance >= 0) return;
  face->normal = -face->normal;
  face->offset = -face->offset;
  for (auto& triangle : face->triangles) std::swap(triangle[1], triangle[2]);
  for (FaceLoop& loop : face->loops) {
    std::ranges::reverse(loop);
    for (FaceEdge& edge : loop) {
      std::swap(edge.from, edge.to);
      std::ranges::reverse(edge.bridge);
    }
  }
}

class FaceFinder {
 public:
  FaceFinder(const SurfaceImages& images, const DrawingGraph& graph, const SurfaceOptions& options,
             const RunContext& context)
      : images_(images), graph_(graph), options_(options), context_(context) {
    const std::vector<FaceLink> links = MeasureFaceLinks(graph, images.views, options);
    const std::vector<FacePlane> planes = FindFacePlanes(links, graph, options, context);
    planes_.resize(planes.size());
    ParallelFor(context, "planes", planes.size(), [&](size_t p) {
      planes_[p] = FindPlaneCells(planes[p], links, graph, options);
    });
  }

  SurfaceResult Run() {
    std::vector<FaceCandidate> candidates;
    for (const PlaneCells& plane : planes_) {
      for (const ArrangementCell& cell : plane.cells) {
        candidates.push_back(CandidateOf(plane, cell));
      }
    }
    evidence_ = FindFaceEvidence(images_, graph_, candidates, options_, context_);
    SurfaceResult result = {graph_, {}};
    result.graph.faces = Faces();
    result.summary = Summarize(result.graph.faces);
    return result;
  }

 private:
  bool IsFace(const FaceEvidence& evidence) const {
    return !IsSeenThrough(evidence, options_) && evidence.seen_share >= options_.min_seen_share &&
           evidence.seen_share > 0;
  }

  std::vector<DrawingFace> Faces() const {
    std::vector<DrawingFace> faces;
    size_t first = 0;
    for (const PlaneCells& plane : planes_) {
      const auto begin = evidence_.begin() + static_cast<std::ptrdiff_t>(first);
      const std::vector<FaceEvidence> of_plane(
          begin, begin + static_cast<std::ptrdiff_t>(plane.cells.size()));
      first += plane.cells.size();
      std::ranges::move(FacesOf(plane, of_plane), std::back_inserter(faces));
    }
    return faces;
  }

  std::vector<DrawingFace> FacesOf(const PlaneCells& plane,
                                   const std::vector<FaceEvidence>& evidence) const {
    std::vector<uint8_t> is_face;
    for (const FaceEvidence& of_cell : evidence) is_face.push_back(IsFace(of_cell));
    std::vector<MadeFace> made = MakeFaces(plane, is_face);
    std::vector<DrawingFace> faces;
    for (MadeFace& of_cells : made) {
      DrawingFace& face = of_cells.face;
      face.confidence = 1;
      for (const int cell : of_cells.cells) {
        face.confidence = std::min(face.confidence, ConfidenceOf(evidence[cell], options_));
        face.views.insert(face.views.end(), evidence[cell].views.begin(),
                          evidence[cell].views.end());
      }
      std::ranges::sort(face.views);
      face.views.erase(std::unique(face.views.begin(), face.views.end()), face.views.end());
      TurnToViews(images_.views, &face);
      faces.push_back(std::move(face));
    }
    return faces;
  }

  StageSummary Summarize(const std::vector<DrawingFace>& faces) const {
    int64_t num_faces = 0, num_seen_through = 0, num_hidden = 0;
    for (const FaceEvidence& evidence : evidence_) {
      if (IsFace(evidence)) {
        ++num_faces;
      } else {
        ++(IsSeenThrough(evidence, options_) ? num_seen_through : num_hidden);
      }
    }
    StageSummary summary;
    summary.stage = "surfaces";
    summary.in = {{"planes", std::ssize(planes_)}, {"cells", std::ssize(evidence_)}};
    summary.kept = {{"planes", std::ssize(planes_)},
                    {"cells", num_faces},
                    {"faces", std::ssize(faces)},
                    {"faces with bridges", std::ranges::count_if(faces, &HasBridges)}};
    summary.dropped = {{"cells: seen through", num_seen_through},
                       {"cells: border not seen at once", num_hidden}};
    return summary;
  }

  const SurfaceImages& images_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  const RunContext& context_;
  std::vector<PlaneCells> planes_;
  std::vector<FaceEvidence> evidence_;  // of the cells of all planes in order
};

}  // namespace

SurfaceResult FindFaces(const SurfaceImages& images, const DrawingGraph& graph,
                        const SurfaceOptions& options, const RunContext& context) {
  options.Check();
  return FaceFinder(images, graph, options, context).Run();
}

}  // namespace limn
