// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edge_map.h"

namespace limn {

// An ordered chain of edgels of one image. Never smoothed or resampled: fragment vertex = edgel,
// because support is counted in edgels.
struct CurveFragment {
  std::vector<EdgelId> edgel_ids;
  // The last edgel is followed by the first one (which is not repeated).
  bool closed = false;
};

// The curves of one image: input of every multi-view stage.
struct ImageCurves {
  EdgeMap edge_map;
  std::vector<CurveFragment> fragments;
  // Edgels outside texture that the linker linked to no other.
  int num_unlinked = 0;
};

}  // namespace limn
