// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "limn/sketch/fragment_chords.h"
#include "limn/sketch/sketch.h"
#include "limn/support/edgel_index.h"
#include "limn/support/orientation_mask.h"

namespace limn {

// The edges of the views that a sketch is working on, so that its memory does not grow with the
// scene. Per view; null for other views.
struct SketchEdgels {
  explicit SketchEdgels(size_t num_views)
      : indices(num_views), masks(num_views), chords(num_views) {}

  std::vector<std::unique_ptr<EdgelIndex>> indices;
  std::vector<std::unique_ptr<OrientationMask>> masks;
  std::vector<std::unique_ptr<FragmentChords>> chords;
};

// Releases all views but these (ascending) and adds those that are missing. The image curves must
// outlive the result.
void HoldViews(const std::vector<ViewId>& ids, const SketchInput& input, const SupportGate& gate,
               const RunContext& context, SketchEdgels* edgels);

}  // namespace limn
