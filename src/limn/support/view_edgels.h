#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/support/edgel_index.h"
#include "limn/util/parallel.h"

namespace limn {

// The edges of one view, indexed for the multi-view stages. Only edgels of fragments count as
// support; an isolated edgel may be noise.
struct ViewEdgels {
  explicit ViewEdgels(const ImageCurves& curves);

  std::vector<int> fragment_of;  // per edgel: its fragment, or -1
  EdgelIndex edgels;
};

// One per view.
std::vector<std::unique_ptr<ViewEdgels>> BuildViewEdgels(const std::vector<ImageCurves>& curves,
                                                         const RunContext& context);

}  // namespace limn
