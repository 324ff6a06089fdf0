#include "limn/surfaces/find_faces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "limn/surfaces/choose_cells.h"

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
      : images_(images), graph_(graph), options_(options), context_(context) {}

  SurfaceResult Run() {
    FindPlanes();
    FindCells();
    fates_ = ChooseCells(images_.views, graph_, planes_, cells_, options_, context_);
    SurfaceResult result = {graph_, {}};
    result.graph.faces = Faces();
    result.summary = Summarize(result.graph.faces);
    return result;
  }

 private:
  void FindPlanes() {
    const std::vector<FaceLink> links = MeasureFaceLinks(graph_, images_.views, options_);
    const std::vector<FacePlane> planes = FindFacePlanes(links, graph_, options_, context_);
    planes_.resize(planes.size());
    ParallelFor(context_, "planes", planes.size(),
                [&](size_t p) { planes_[p] = FindPlaneCells(planes[p], links, graph_, options_); });
  }

  // With their evidence.
  void FindCells() {
    std::vector<FaceCandidate> candidates;
    for (size_t p = 0; p < planes_.size(); ++p) {
      for (size_t c = 0; c < planes_[p].cells.size(); ++c) {
        candidates.push_back(CandidateOf(planes_[p], planes_[p].cells[c]));
        cells_.push_back({p, static_cast<int>(c), {}, {}});
      }
    }
    std::vector<FaceEvidence> evidence =
        FindFaceEvidence(images_, graph_, candidates, options_, context_);
    for (size_t c = 0; c < cells_.size(); ++c) {
      cells_[c].candidate = std::move(candidates[c]);
      cells_[c].evidence = std::move(evidence[c]);
    }
  }

  std::vector<DrawingFace> Faces() const {
    std::vector<DrawingFace> faces;
    size_t first = 0;  // cells are ordered by plane
    for (size_t p = 0; p < planes_.size(); ++p) {
      std::vector<uint8_t> is_face;
      for (size_t c = 0; c < planes_[p].cells.size(); ++c) {
        is_face.push_back(fates_[first + c] == CellFate::kFace);
      }
      for (MadeFace& made : MakeFaces(planes_[p], is_face)) {
        Describe(first, made.cells, &made.face);
        faces.push_back(std::move(made.face));
      }
      first += is_face.size();
    }
    return faces;
  }

  // Sets what is known of the cells that a face is made of.
  void Describe(size_t first, const std::vector<int>& cells, DrawingFace* face) const {
    face->confidence = 1;
    for (const int cell : cells) {
      const FaceEvidence& evidence = cells_[first + static_cast<size_t>(cell)].evidence;
      face->confidence = std::min(face->confidence, ConfidenceOf(evidence, options_));
      std::ranges::copy(ViewsOf(evidence), std::back_inserter(face->views));
    }
    std::ranges::sort(face->views);
    face->views.erase(std::unique(face->views.begin(), face->views.end()), face->views.end());
    TurnToViews(images_.views, face);
  }

  StageSummary Summarize(const std::vector<DrawingFace>& faces) const {
    std::array<int64_t, 4> num = {};
    for (const CellFate fate : fates_) ++num[static_cast<size_t>(fate)];
    StageSummary summary;
    summary.stage = "surfaces";
    summary.in = {{"cells", std::ssize(cells_)}};
    summary.kept = {{"cells", num[static_cast<size_t>(CellFate::kFace)]},
                    {"planes", std::ssize(planes_)},
                    {"faces", std::ssize(faces)},
                    {"faces with bridges", std::ranges::count_if(faces, &HasBridges)}};
    summary.dropped = {
        {"cells: seen through", num[static_cast<size_t>(CellFate::kSeenThrough)]},
        {"cells: border not seen at once", num[static_cast<size_t>(CellFate::kUnseen)]},
        {"cells: behind other faces", num[static_cast<size_t>(CellFate::kBehind)]}};
    return summary;
  }

  const SurfaceImages& images_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  const RunContext& context_;
  std::vector<PlaneCells> planes_;
  std::vector<CellChoice> cells_;
  std::vector<CellFate> fates_;
};

}  // namespace

SurfaceResult FindFaces(const SurfaceImages& images, const DrawingGraph& graph,
                        const SurfaceOptions& options, const RunContext& context) {
  options.Check();
  return FaceFinder(images, graph, options, context).Run();
}

}  // namespace limn
