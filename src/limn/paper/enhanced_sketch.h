// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/sketch/sketch.h"

namespace limn {

// With the rule of support that their averaging asks for: the paper's counts views by their weights
// alone.
SketchOptions WithSupportRule(SketchOptions options);

// The enhanced curve sketch (ECCV 2016, section 2), the paper's baseline (ii): local support sample
// by sample, weights near epipolar tangency, and robust averaging in inverse depth of all
// reconstructions of the same edgel of the primary view. Views in the store are not sketched again.
SketchResult BuildEnhancedSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context, const ViewSketchStore* store = nullptr);

}  // namespace limn
