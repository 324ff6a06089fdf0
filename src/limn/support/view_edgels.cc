// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/view_edgels.h"

#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

std::vector<FragmentPlace> PlacesOfEdgels(const ImageCurves& curves) {
  std::vector<FragmentPlace> place_of(curves.edge_map.edgels.size());
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    const std::vector<EdgelId>& ids = curves.fragments[f].edgel_ids;
    for (size_t i = 0; i < ids.size(); ++i) {
      place_of[ids[i]] = {static_cast<int>(f), static_cast<int>(i)};
    }
  }
  return place_of;
}

std::vector<Eigen::Vector2f> AcrossEdgels(const EdgeMap& edge_map) {
  std::vector<Eigen::Vector2f> across;
  across.reserve(edge_map.edgels.size());
  for (const Edgel& edgel : edge_map.edgels) {
    across.push_back(EdgelLine(edgel).across.cast<float>());
  }
  return across;
}

}  // namespace

ViewEdgels::ViewEdgels(const ImageCurves& curves)
    : place_of(PlacesOfEdgels(curves)),
      across(AcrossEdgels(curves.edge_map)),
      edgels(curves.edge_map, LinkedEdgels(curves)) {}

std::vector<std::unique_ptr<ViewEdgels>> BuildViewEdgels(const std::vector<ImageCurves>& curves,
                                                         const RunContext& context) {
  std::vector<std::unique_ptr<ViewEdgels>> edgels(curves.size());
  ParallelFor(context, "indexing edgels", curves.size(),
              [&](size_t v) { edgels[v] = std::make_unique<ViewEdgels>(curves[v]); });
  return edgels;
}

}  // namespace limn
