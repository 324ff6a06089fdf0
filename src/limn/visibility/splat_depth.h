// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/visibility/depth_image.h"

namespace limn {

// Per depth pixel, the depth of the nearest point that projects within `radius_px` (virtual px) of
// its center. The radius should be about the distance between neighboring points in the view: a
// smaller one leaves holes, a larger one widens the foreground. On slanted surfaces the result is
// too near by up to radius times slope footprints. Time: points times the depth pixels in a disc.
// Throws InputError if these are too many (RasterWork).
DepthImage SplatDepth(const std::vector<Eigen::Vector3d>& points_in_world, const View& view,
                      double scale, double radius_px);

}  // namespace limn
