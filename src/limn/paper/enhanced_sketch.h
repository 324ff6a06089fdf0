#pragma once

#include "limn/sketch/sketch.h"

namespace limn {

// The enhanced curve sketch (ECCV 2016, section 2), the paper's baseline (ii): local support sample
// by sample, weights near epipolar tangency, and robust averaging in inverse depth of all
// reconstructions of the same edgel of the primary view. Views in the store are not sketched again.
SketchResult BuildEnhancedSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context, const ViewSketchStore* store = nullptr);

}  // namespace limn
