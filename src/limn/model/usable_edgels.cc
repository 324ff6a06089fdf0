// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/usable_edgels.h"

#include <utility>

namespace limn {
namespace {

// The usable runs of a fragment. Of a closed one the last run may continue in the first.
std::vector<CurveFragment> UsableRuns(const CurveFragment& fragment,
                                      const std::vector<bool>& usable) {
  const auto& ids = fragment.edgel_ids;
  const size_t size = ids.size();
  size_t first_gap = 0;
  while (first_gap < size && usable[ids[first_gap]]) ++first_gap;
  if (first_gap == size) return {fragment};
  // Start a closed fragment at a gap, so that no run passes the end.
  const size_t start = fragment.closed ? first_gap : 0;
  std::vector<CurveFragment> runs;
  CurveFragment run;
  for (size_t k = 0; k <= size; ++k) {
    const EdgelId id = k < size ? ids[(start + k) % size] : kInvalidEdgel;
    if (id != kInvalidEdgel && usable[id]) {
      run.edgel_ids.push_back(id);
      continue;
    }
    if (run.edgel_ids.size() >= 2) runs.push_back(run);
    run.edgel_ids.clear();
  }
  return runs;
}

}  // namespace

void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves) {
  std::vector<CurveFragment> fragments;
  for (const CurveFragment& fragment : curves->fragments) {
    for (CurveFragment& run : UsableRuns(fragment, usable)) fragments.push_back(std::move(run));
  }
  curves->fragments = std::move(fragments);
}

}  // namespace limn
