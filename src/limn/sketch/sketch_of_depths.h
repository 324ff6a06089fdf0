// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/view.h"
#include "limn/sketch/view_sketch.h"

namespace limn {

// The sketch of a view with these depths, without support.
ViewSketch SketchOfDepths(ViewId id, const View& view, const ImageCurves& curves,
                          const ViewDepths& depths);

// The fates of edgels that are in no fragment; of the others, kNotLinked.
std::vector<EdgelFate> FatesOutsideFragments(const EdgeMap& edge_map);

}  // namespace limn
