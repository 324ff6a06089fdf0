#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/dense/curve_points.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// The model with samples of the curves as 3D points: each has a track over the views that see it,
// at least two, with a new 2D point at its reprojection in every one of them. Neighboring samples
// of a link are `every` samples apart.
SparseModel AddCurvePoints(SparseModel model, const std::vector<CurvePoint>& points,
                           const std::vector<View>& views, int every);

}  // namespace limn::colmap_ext
