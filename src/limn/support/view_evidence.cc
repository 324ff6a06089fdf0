#include "limn/support/view_evidence.h"

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

ViewEvidence::ViewEvidence(const View& view, const ImageCurves& curves, const SupportGate& gate)
    : fragment_of(FragmentOfEdgels(curves)),
      edgels(curves.edge_map, LinkedEdgels(curves)),
      mask(curves.edge_map, LinkedEdgels(curves), view.region, gate) {}

std::vector<std::unique_ptr<ViewEvidence>> BuildEvidence(const std::vector<View>& views,
                                                         const std::vector<ImageCurves>& curves,
                                                         const SupportGate& gate,
                                                         const RunContext& context) {
  std::vector<std::unique_ptr<ViewEvidence>> evidence(views.size());
  ParallelFor(context, "evidence", views.size(), [&](size_t i) {
    evidence[i] = std::make_unique<ViewEvidence>(views[i], curves[i], gate);
  });
  return evidence;
}

}  // namespace limn
