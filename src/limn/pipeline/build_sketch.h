// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/sketch/sketch.h"

namespace limn {

// How a sketch is made.
enum class SketchMode { kOriginal, kEnhanced, kSweep };

const char* SketchModeName(SketchMode mode);

// The sketch of this mode: BuildSweptSketch (ours), or one of the paper's baselines. The original
// sketch uses no store, since it compares the curves of all views.
SketchResult BuildSketch(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         const RunContext& context, const ViewSketchStore* store = nullptr);

}  // namespace limn
