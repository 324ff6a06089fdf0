// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/support/edgel_index.h"
#include "limn/util/parallel.h"

namespace limn {

// Where an edgel is on a fragment.
struct FragmentPlace {
  int fragment = -1;  // -1: on none
  int index = -1;     // in its edgel_ids
};

// The edges of one view, indexed for the multi-view stages. Only edgels of fragments count as
// support; an isolated edgel may be noise.
struct ViewEdgels {
  explicit ViewEdgels(const ImageCurves& curves);

  std::vector<FragmentPlace> place_of;  // per edgel
  // Per edgel, its EdgelLine::across, stored because it is needed so often.
  std::vector<Eigen::Vector2f> across;
  EdgelIndex edgels;
};

// One per view.
std::vector<std::unique_ptr<ViewEdgels>> BuildViewEdgels(const std::vector<ImageCurves>& curves,
                                                         const RunContext& context);

}  // namespace limn
