// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include <Eigen/Core>

#include "limn/cameras/camera_covariance.h"
#include "limn/cameras/camera_mounts.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// How well cameras are known.
struct CameraUncertainty {
  CameraCovariance covariance;
  double shift_unit = 1;  // of shifts in the covariance, world units
  CameraMounts mounts;    // exact
  // Per camera that is adjusted (ParametersPerPx).
  std::map<int, Eigen::VectorXd> parameters_per_px;
};

// Standard deviation of the image of a point, px, root of the mean over two directions: the motion
// of the camera while the point stays. 0 for a held camera, and behind it.
double CertainByPx(const CameraUncertainty& cameras, const std::vector<View>& views, ViewId view,
                   const Eigen::Vector3d& point_in_world);

// Adds to the sigmas of a drawing, which are those of fits to the edgels of its supporting views
// with these cameras right, how far curves move across themselves when cameras move as they may.
// Time: per vertex the square of the number of unknowns of its views.
void AddShareOfCameras(const CameraUncertainty& cameras, const std::vector<View>& views,
                       const RunContext& context, DrawingGraph* graph);

}  // namespace limn
