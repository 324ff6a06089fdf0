#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "limn/model/view.h"

namespace limn {

// The similarity that brings refined cameras back to the given ones: what images cannot tell shall
// not change. Least squares over all cameras' centers and the points one arm, from the given center
// to the `middle` of the scene, along their axes: cameras count by what they do to the image of the
// scene, and even two of them fix all. The scale is 1 if all given centers are the same. Same views
// in both, of which at least one.
Eigen::Affine3d GivenFromRefined(const std::vector<View>& given, const std::vector<View>& refined,
                                 const Eigen::Vector3d& middle);

// The views in a world moved by a similarity: they see the moved scene as they saw it before.
std::vector<View> Moved(const std::vector<View>& views, const Eigen::Affine3d& similarity);

}  // namespace limn
