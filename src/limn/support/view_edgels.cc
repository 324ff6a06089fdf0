#include "limn/support/view_edgels.h"

namespace limn {
namespace {

std::vector<int> FragmentOfEdgels(const ImageCurves& curves) {
  std::vector<int> fragment_of(curves.edge_map.edgels.size(), -1);
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    for (const EdgelId id : curves.fragments[f].edgel_ids) fragment_of[id] = static_cast<int>(f);
  }
  return fragment_of;
}

}  // namespace

ViewEdgels::ViewEdgels(const ImageCurves& curves)
    : fragment_of(FragmentOfEdgels(curves)), edgels(curves.edge_map, LinkedEdgels(curves)) {}

std::vector<std::unique_ptr<ViewEdgels>> BuildViewEdgels(const std::vector<ImageCurves>& curves,
                                                         const RunContext& context) {
  std::vector<std::unique_ptr<ViewEdgels>> edgels(curves.size());
  ParallelFor(context, "indexing edgels", curves.size(),
              [&](size_t v) { edgels[v] = std::make_unique<ViewEdgels>(curves[v]); });
  return edgels;
}

}  // namespace limn
