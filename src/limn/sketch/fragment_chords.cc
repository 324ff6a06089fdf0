// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/fragment_chords.h"

#include <algorithm>

namespace limn {

FragmentChords::FragmentChords(const ImageCurves& curves) {
  size_t num_ends = 0;
  for (const CurveFragment& fragment : curves.fragments) {
    num_ends += fragment.edgel_ids.size() + (fragment.closed ? 1 : 0);
  }
  ends_.reserve(num_ends);
  first_end_ = {0};
  for (const CurveFragment& fragment : curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) {
      const Edgel& edgel = curves.edge_map.edgels[id];
      ends_.push_back({edgel.position_px.cast<float>(), edgel.Tangent().cast<float>()});
    }
    if (fragment.closed) ends_.push_back(ends_[first_end_.back()]);
    first_end_.push_back(static_cast<int>(ends_.size()));
  }
}

FragmentPlace FragmentChords::PlaceOf(int chord) const {
  const auto after = std::upper_bound(first_end_.begin(), first_end_.end(), chord);
  const auto fragment = static_cast<int>(after - first_end_.begin()) - 1;
  return {fragment, chord - first_end_[fragment]};
}

}  // namespace limn
