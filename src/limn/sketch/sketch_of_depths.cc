// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/sketch_of_depths.h"

#include <utility>

#include "limn/sketch/sketch_pieces.h"

namespace limn {
namespace {

class SketchMaker {
 public:
  SketchMaker(ViewId id, const View& view, const ImageCurves& curves)
      : id_(id), view_(view), curves_(curves) {
    sketch_.fates = FatesOutsideFragments(curves.edge_map);
  }

  void Add(int fragment_id, const ViewDepths& of_view) {
    const DepthProfile& profile = of_view.of_fragment[fragment_id];
    const FragmentRays fragment = MakeFragmentRays(view_, curves_, fragment_id);
    if (profile.depths.empty()) {
      for (size_t i = 0; i < fragment.size(); ++i) {
        Fate(fragment_id, i) = EdgelFate::kFragmentTooShort;
      }
      return;
    }
    const std::vector<int> vertices = SpacedVertices(fragment, of_view.spacing_px);
    for (size_t i = 0; i < vertices.size(); ++i) {
      const EdgelFate fate =
          profile.depths[i].has_depth ? EdgelFate::kPieceTooShort : profile.fates[i];
      const size_t next = i + 1 < vertices.size() ? vertices[i + 1] : fragment.size();
      for (size_t k = vertices[i]; k < next; ++k) Fate(fragment_id, k) = fate;
    }
    std::vector<FusedDepth> depths = ExpandDepths(fragment, vertices, profile.depths);
    InterpolateGaps(fragment, &depths);
    for (const VertexRun& run : FindRuns(fragment, depths)) {
      for (int k = 0; k < run.size; ++k) {
        Fate(fragment_id, (run.begin + k) % fragment.size()) = EdgelFate::kSketched;
      }
      Curve3D curve = MakeCurve(view_, fragment, depths, run, of_view.sample_step);
      curve.anchor.view = id_;
      curve.anchor.fragment = fragment_id;
      sketch_.curves.push_back(std::move(curve));
    }
  }

  ViewSketch Take() { return std::move(sketch_); }

 private:
  EdgelFate& Fate(int fragment, size_t vertex) {
    return sketch_.fates[curves_.fragments[fragment].edgel_ids[vertex]];
  }

  const ViewId id_;
  const View& view_;
  const ImageCurves& curves_;
  ViewSketch sketch_;
};

}  // namespace

std::vector<EdgelFate> FatesOutsideFragments(const EdgeMap& edge_map) {
  std::vector<EdgelFate> fates(edge_map.edgels.size(), EdgelFate::kNotLinked);
  for (const EdgelId id : edge_map.texture) fates[id] = EdgelFate::kTexture;
  return fates;
}

ViewSketch SketchOfDepths(ViewId id, const View& view, const ImageCurves& curves,
                          const ViewDepths& depths) {
  SketchMaker maker(id, view, curves);
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    maker.Add(static_cast<int>(f), depths);
  }
  return maker.Take();
}

}  // namespace limn
