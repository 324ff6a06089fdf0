#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/visibility/depth_image.h"

namespace limn {

// Both functions change only depth pixels that are unknown or farther.

// Sets the depth pixels with centers in a convex polygon, border included, to `depth_at` of their
// position in the virtual image. Corners are in depth pixels (DepthImage::FromVirtual).
void FillPolygon(const std::vector<Eigen::Vector2d>& corners,
                 const std::function<double(const Eigen::Vector2d& virtual_px)>& depth_at,
                 DepthImage* image);

// Sets the depth pixels with centers within `radius` of a position, both in depth pixels, to z.
void FillDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image);

}  // namespace limn
