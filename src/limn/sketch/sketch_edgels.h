#pragma once

#include <memory>
#include <vector>

#include "limn/sketch/sketch.h"
#include "limn/support/orientation_mask.h"
#include "limn/support/view_edgels.h"

namespace limn {

// What a sketch asks of the edges of the views: only of those it works on, so that its memory does
// not grow with the scene. Per view, null for the others.
struct SketchEdgels {
  explicit SketchEdgels(size_t num_views) : views(num_views), masks(num_views) {}

  std::vector<std::unique_ptr<ViewEdgels>> views;
  std::vector<std::unique_ptr<OrientationMask>> masks;
};

// Forget all views but these, ascending, and make what is missing of theirs. The image curves must
// outlive them.
void HoldViews(const std::vector<ViewId>& ids, const SketchInput& input, const SupportGate& gate,
               const RunContext& context, SketchEdgels* edgels);

}  // namespace limn
