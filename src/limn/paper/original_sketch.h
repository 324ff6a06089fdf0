// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/sketch/sketch.h"

namespace limn {

// The 3D curve sketch (Fabbri and Kimia, CVPR 2010), the paper's baseline (i): for every pair of
// primary and second view, image curves that overlap epipolarly are matched, triangulated, and kept
// when the whole curve has enough edge support in the confirmation views. Portions tangent to
// epipolar lines are cut away. Duplicates are the rule: one curve per pair of views.
SketchResult BuildOriginalSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context);

}  // namespace limn
