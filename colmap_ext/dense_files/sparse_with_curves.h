// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/dense/curve_points.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Adds samples of the curves to the model as 3D points, every `every`-th sample of a link. Each has
// a track over the views that see it, at least two, with a new 2D point at its reprojection in each
// of them.
SparseModel AddCurvePoints(SparseModel model, const std::vector<CurvePoint>& points,
                           const std::vector<View>& views, int every);

}  // namespace limn::colmap_ext
