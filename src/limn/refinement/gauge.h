#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "limn/model/view.h"

namespace limn {

// The similarity that best maps refined cameras to the given ones (ALGORITHM.md 16.8), so that
// place, orientation and scale, which images do not determine, stay as given. Least squares over
// the centers of all cameras and three points per camera, along its axes at the distance of the
// `middle` of the scene: cameras are weighted by their effect on the image of the scene, and two of
// them determine the similarity. The scale is 1 if all given centers coincide. Precondition: the
// same views in both, at least one.
Eigen::Affine3d GivenFromRefined(const std::vector<View>& given, const std::vector<View>& refined,
                                 const Eigen::Vector3d& middle);

// The views moved by a similarity along with the scene: their images of it stay the same.
std::vector<View> Moved(const std::vector<View>& views, const Eigen::Affine3d& similarity);

}  // namespace limn
