#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/visibility/depth_image.h"

namespace limn {

// The depth of the nearest of the points that project within `radius_px` (virtual px) of a depth
// pixel's center. The radius should be about the distance between neighboring points in the view:
// smaller ones leave holes, larger ones widen what stands in front. On a surface seen at a slant
// the result is too near by up to radius times slope footprints. Time: points times the depth
// pixels in a disc.
DepthImage SplatDepth(const std::vector<Eigen::Vector3d>& points_in_world, const View& view,
                      double scale, double radius_px);

}  // namespace limn
