#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/support/edgel_index.h"
#include "limn/util/parallel.h"

namespace limn {

// Everything the multi-view stages ask of the edges of one view. Only edgels that belong to a
// fragment count as support: a lone edgel is as likely noise.
struct ViewEdgels {
  explicit ViewEdgels(const ImageCurves& curves);

  std::vector<int> fragment_of;  // per edgel: its fragment, or -1
  EdgelIndex edgels;
};

// One per view; the curves must outlive the result.
std::vector<std::unique_ptr<ViewEdgels>> BuildViewEdgels(const std::vector<ImageCurves>& curves,
                                                         const RunContext& context);

}  // namespace limn
