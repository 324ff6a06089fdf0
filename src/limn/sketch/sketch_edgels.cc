// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/sketch_edgels.h"

#include <algorithm>

namespace limn {

void HoldViews(const std::vector<ViewId>& ids, const SketchInput& input, const SupportGate& gate,
               const RunContext& context, SketchEdgels* edgels) {
  std::vector<ViewId> missing;
  for (ViewId v = 0; v < static_cast<ViewId>(input.scene.views.size()); ++v) {
    if (!std::binary_search(ids.begin(), ids.end(), v)) {
      edgels->indices[v].reset();
      edgels->masks[v].reset();
      edgels->chords[v].reset();
    } else if (!edgels->indices[v]) {
      missing.push_back(v);
    }
  }
  RunContext quietly = context;  // a step of the sketch, which reports its own progress
  quietly.progress = nullptr;
  ParallelFor(quietly, "indexing edgels", missing.size(), [&](size_t m) {
    const ViewId v = missing[m];
    const ImageCurves& curves = input.scene.curves[v];
    const std::vector<bool> linked = LinkedEdgels(curves);
    edgels->indices[v] = std::make_unique<EdgelIndex>(curves.edge_map, linked);
    edgels->masks[v] = std::make_unique<OrientationMask>(curves.edge_map, linked,
                                                         input.scene.views[v].region, gate);
    edgels->chords[v] = std::make_unique<FragmentChords>(curves);
  });
}

}  // namespace limn
