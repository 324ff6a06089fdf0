// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// Unit directions in the coordinates of two cameras, a pixel per column.
struct RayPairs {
  Eigen::Matrix3Xd first, second;
};

// The rays of two views of the same picture through the same stored pixels, spread over the image.
// Pixels that a lens cannot map are left out.
RayPairs RaysThroughSamePixels(const View& first, const View& second);

// The view turned about its center such that its rays are as they would be with the optics of
// `other`, a view of the same picture: a principal point that moves turns a camera that fits its
// image, and this turns it back.
View WithRaysInOpticsOf(const View& other, View view);

}  // namespace limn
