// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// The model that `views` were made from with the curves of a drawing as 3D points, for viewers that
// show points: samples at most `spacing_px` pixels apart in the color of their curve
// (ColorOfCurve), with error 0 and a track over the views that support their link and have them in
// their region. Samples that fewer than two of these have are left out. Throws IoError if the
// drawing has images that the model has not, and InputError for EQUIRECTANGULAR images, whose parts
// have no pixels of their own in the model.
SparseModel WithCurves(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                       double spacing_px);

}  // namespace limn::colmap_ext
