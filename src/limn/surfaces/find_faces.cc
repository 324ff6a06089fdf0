// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/find_faces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "limn/surfaces/choose_cells.h"
#include "limn/surfaces/flat_candidates.h"
#include "limn/surfaces/hidden_links.h"
#include "limn/surfaces/patch_candidates.h"
#include "limn/surfaces/ruled_candidates.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// How many more of the places that are seen are seen from the side that the normals point to, than
// from the other one.
int FrontBalance(const std::vector<View>& views, const CellChoice& choice) {
  int balance = 0;
  for (const auto& [view, sights] : choice.evidence.sights) {
    const Eigen::Vector3d eye = views[view].CenterInWorld();
    for (size_t p = 0; p < sights.size(); ++p) {
      const CandidatePlace& place = choice.candidate.places[p];
      if (sights[p] != PlaceSight::kSeen) continue;
      balance += place.normal.dot(eye - place.position) > 0 ? 1 : -1;
    }
  }
  return balance;
}

void TurnRound(DrawingFace* face) {
  face->normal = -face->normal;
  face->offset = -face->offset;
  for (auto& triangle : face->triangles) std::swap(triangle[1], triangle[2]);
  for (FaceLoop& loop : face->loops) {
    std::ranges::reverse(loop);
    for (FaceEdge& edge : loop) {
      std::swap(edge.from, edge.to);
      std::ranges::reverse(edge.bridge);
    }
    // Rails are the first and third side.
    if (!face->side_starts.empty()) std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
}

class FaceFinder {
 public:
  FaceFinder(const CurvesScene& scene, const SupportGate& gate, const DrawingGraph& graph,
             const SurfaceOptions& options, const RunContext& context)
      : scene_(scene), gate_(gate), graph_(graph), options_(options), context_(context) {}

  SurfaceResult Run() {
    FindCandidates();
    FindEvidence();
    fates_ = ChooseCells(scene_.views, graph_, planes_, cells_, options_, context_);
    SurfaceResult result = {graph_, {}, {}};
    result.graph.faces = Faces();
    result.links_behind = LinksBehindFaces(scene_.views, result.graph, context_);
    result.summary = Summarize(result.graph.faces);
    return result;
  }

 private:
  // Cells of planes, by plane, then bent surfaces.
  void FindCandidates() {
    const std::vector<FaceLink> links = MeasureFaceLinks(graph_, scene_.views, options_);
    const std::vector<FacePlane> planes = FindFacePlanes(links, graph_, options_, context_);
    planes_.resize(planes.size());
    ParallelFor(context_, "planes", planes.size(),
                [&](size_t p) { planes_[p] = FindPlaneCells(planes[p], links, graph_, options_); });
    for (size_t p = 0; p < planes_.size(); ++p) {
      for (size_t c = 0; c < planes_[p].cells.size(); ++c) {
        cells_.push_back({static_cast<int>(p),
                          static_cast<int>(c),
                          FlatCandidate(planes_[p], planes_[p].cells[c]),
                          {}});
      }
    }
    AddBent(FindRuledCandidates(links, graph_, options_));
    AddBent(FindPatchCandidates(links, graph_, options_));
  }

  void AddBent(std::vector<BentCandidate> candidates) {
    for (BentCandidate& bent : candidates) {
      cells_.push_back({-1, static_cast<int>(bent_.size()), std::move(bent.candidate), {}});
      bent_.push_back(std::move(bent.face));
    }
  }

  void FindEvidence() {
    std::vector<FaceCandidate> candidates;
    for (CellChoice& cell : cells_) candidates.push_back(std::move(cell.candidate));
    std::vector<FaceEvidence> evidence =
        FindFaceEvidence(scene_, gate_, graph_, candidates, options_, context_);
    for (size_t c = 0; c < cells_.size(); ++c) {
      cells_[c].candidate = std::move(candidates[c]);
      cells_[c].evidence = std::move(evidence[c]);
    }
  }

  std::vector<DrawingFace> Faces() const {
    std::vector<DrawingFace> faces;
    size_t first = 0;
    for (size_t p = 0; p < planes_.size(); ++p) {
      std::vector<uint8_t> is_face;
      for (size_t c = 0; c < planes_[p].cells.size(); ++c) {
        is_face.push_back(fates_[first + c] == CellFate::kFace);
      }
      for (MadeFace& made : MakeFaces(planes_[p], is_face)) {
        for (int& cell : made.cells) cell += static_cast<int>(first);
        Describe(made.cells, &made.face);
        faces.push_back(std::move(made.face));
      }
      first += is_face.size();
    }
    for (size_t r = 0; r < bent_.size(); ++r) {
      if (fates_[first + r] != CellFate::kFace) continue;
      faces.push_back(bent_[r]);
      Describe({static_cast<int>(first + r)}, &faces.back());
    }
    return faces;
  }

  // Sets what is known of the candidates that a face is made of.
  void Describe(const std::vector<int>& cells, DrawingFace* face) const {
    face->confidence = 1;
    int front_balance = 0;
    for (const int c : cells) {
      face->confidence = std::min(face->confidence, ConfidenceOf(cells_[c], options_));
      std::ranges::copy(ViewsOf(cells_[c]), std::back_inserter(face->views));
      front_balance += FrontBalance(scene_.views, cells_[c]);
    }
    SortUnique(&face->views);
    if (front_balance < 0) TurnRound(face);
  }

  StageSummary Summarize(const std::vector<DrawingFace>& faces) const {
    std::array<int64_t, kNumCellFates> num = {};
    for (const CellFate fate : fates_) ++num[static_cast<size_t>(fate)];
    StageSummary summary;
    summary.stage = "surfaces";
    summary.in = {{"cells", std::ssize(cells_)}};
    summary.kept = {
        {"cells", num[static_cast<size_t>(CellFate::kFace)]},
        {"planes", std::ssize(planes_)},
        {"faces", std::ssize(faces)},
        {"ruled faces", std::ranges::count(faces, FaceSurface::kRuled, &DrawingFace::surface)},
        {"patches", std::ranges::count(faces, FaceSurface::kPatch, &DrawingFace::surface)},
        {"faces with bridges", std::ranges::count_if(faces, &HasBridges)}};
    summary.dropped = {
        {"cells: seen through", num[static_cast<size_t>(CellFate::kSeenThrough)]},
        {"cells: border not seen at once", num[static_cast<size_t>(CellFate::kUnseen)]},
        {"cells: behind other faces", num[static_cast<size_t>(CellFate::kBehind)]},
        {"cells: on other faces", num[static_cast<size_t>(CellFate::kCopy)]}};
    return summary;
  }

  const CurvesScene& scene_;
  const SupportGate& gate_;
  const DrawingGraph& graph_;
  const SurfaceOptions& options_;
  const RunContext& context_;
  std::vector<PlaneCells> planes_;
  std::vector<DrawingFace> bent_;
  std::vector<CellChoice> cells_;
  std::vector<CellFate> fates_;
};

}  // namespace

SurfaceResult FindFaces(const CurvesScene& scene, const SupportGate& gate,
                        const DrawingGraph& graph, const SurfaceOptions& options,
                        const RunContext& context) {
  options.Check();
  return FaceFinder(scene, gate, graph, options, context).Run();
}

}  // namespace limn
