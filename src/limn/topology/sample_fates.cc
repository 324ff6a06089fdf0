// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/sample_fates.h"

#include <algorithm>

namespace limn {

void UpdateFates(const DrawingGraph& graph, EdgelFate fate_of_lost, SampleFates* fates) {
  for (std::vector<EdgelFate>& of_curve : *fates) {
    std::replace(of_curve.begin(), of_curve.end(), EdgelFate::kDrawn, fate_of_lost);
  }
  for (const DrawingLink& link : graph.links) {
    for (const LinkVertex& vertex : link.vertices) {
      for (const SketchSample& from : vertex.samples) {
        (*fates)[from.curve][from.sample] = EdgelFate::kDrawn;
      }
    }
  }
}

}  // namespace limn
