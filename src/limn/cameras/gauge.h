// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "limn/model/view.h"

namespace limn {

// A camera that the refinement moved much farther than most.
struct FarMove {
  ViewId view = -1;
  double px = 0;  // in its image of the scene, relative to the cameras that stay
};

struct Gauge {
  Eigen::Affine3d given_from_refined = Eigen::Affine3d::Identity();
  std::vector<FarMove> moved_far;  // ascending by view
  std::vector<double> moves_px;    // per view, in its image of the scene
  double typical_move_px = 0;      // their median
};

// The similarity that best maps most refined cameras to the given ones
// (algorithm/cameras.md#gauge), so that position, orientation and scale, which images do not
// determine, stay as given. Least squares over the centers of cameras and three points per camera,
// along its axes at the distance of the `middle` of the scene: cameras are weighted by their effect
// on the image of the scene, and two of them determine the similarity. Of four or more cameras,
// those that moved far, in pixels and compared with the others, do not count: they were wrong, and
// must not move the world. The scale is 1 if all given centers coincide. Of views that are held,
// which the refinement did not move, the similarity moves none: it is the best scale about their
// center, and the identity if they have several. Precondition: the same views in both, at least
// one.
Gauge FindGauge(const std::vector<View>& given, const std::vector<View>& refined,
                const Eigen::Vector3d& middle, const std::vector<ViewId>& held = {});

// The views moved by a similarity along with the scene: their images of it stay the same.
std::vector<View> Moved(const std::vector<View>& views, const Eigen::Affine3d& similarity);

// The refined views in the frame of the given ones. Held views have the given poses to the last
// bit.
std::vector<View> InGivenFrame(const std::vector<View>& given, const std::vector<View>& refined,
                               const Gauge& gauge, const std::vector<ViewId>& held);

}  // namespace limn
