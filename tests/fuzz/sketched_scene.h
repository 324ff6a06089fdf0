// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/edgel_fate.h"
#include "limn/model/view.h"

namespace limn {
struct CurveSketch;
}

namespace limn::fuzz {

// A scene that sketches on disk may be of: two views with a fragment of ten edgels each.
const std::vector<View>& SketchedViews();
const std::vector<ImageCurves>& SketchedCurves();

// Draws from a sketch of the scene that was accepted, as a run continues from it, and accounts for
// the edgels. `fates` are those of a view, or empty.
void DrawAndAccount(const CurveSketch& sketch, ViewId view, const std::vector<EdgelFate>& fates);

}  // namespace limn::fuzz
