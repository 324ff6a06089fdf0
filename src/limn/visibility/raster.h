#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/visibility/depth_image.h"

namespace limn {

// Fill a depth image where it is unknown or farther.

// The centers of depth pixels inside a convex polygon, its border included, at `depth_at` of their
// place in the virtual image. Corners are in depth pixels (DepthImage::FromVirtual).
void FillPolygon(const std::vector<Eigen::Vector2d>& corners,
                 const std::function<double(const Eigen::Vector2d& virtual_px)>& depth_at,
                 DepthImage* image);

// The centers within `radius` of a place, both in depth pixels, at depth z.
void FillDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image);

}  // namespace limn
