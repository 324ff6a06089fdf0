#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/view.h"

namespace limn {

// The local unit of length rho(X): the median over the views that contain X of depth / focal
// length, that is, the width of one pixel at X. A point that no view contains takes the views that
// have it in front of them, and one behind all cameras the least distance / focal length. Always
// positive; occlusion is not looked at. Linear in the number of views. Precondition: there is a
// view.
double PixelFootprint(const std::vector<View>& views, const Eigen::Vector3d& point_in_world);

// The footprint at the middle of the curve's length; 1 for a curve without points.
double FootprintOfCurve(const std::vector<View>& views, const Polyline3d& curve);

}  // namespace limn
