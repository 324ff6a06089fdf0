// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curve_fragment.h"

namespace limn {

// Edges of an image that come from a file, in pixels of the image as stored (after
// --max_image_size), before ApplyLens.
struct GivenEdges {
  ImageCurves curves;
  // The fragments are given, too. Else there are none, and the edgels are still to be linked.
  bool are_linked = false;
};

}  // namespace limn
