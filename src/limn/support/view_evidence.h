#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"
#include "limn/support/orientation_mask.h"
#include "limn/util/parallel.h"

namespace limn {

// Everything the multi-view stages ask of the edges of one view. Only edgels that belong to a
// fragment are evidence: a lone edgel is as likely noise.
struct ViewEvidence {
  ViewEvidence(const View& view, const ImageCurves& curves, const SupportGate& gate);

  std::vector<int> fragment_of;  // per edgel: its fragment, or -1
  EdgelIndex edgels;
  OrientationMask mask;
};

// One per view; the arguments must outlive the result.
std::vector<std::unique_ptr<ViewEvidence>> BuildEvidence(const std::vector<View>& views,
                                                         const std::vector<ImageCurves>& curves,
                                                         const SupportGate& gate,
                                                         const RunContext& context);

}  // namespace limn
