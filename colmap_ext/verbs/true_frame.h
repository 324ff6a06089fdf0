// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/evaluation/camera_accuracy.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Cameras beside the true ones.
struct TrueFrame {
  Eigen::Affine3d true_from_model = Eigen::Affine3d::Identity();  // a similarity
  std::vector<View> views;                                        // with the true cameras
  CameraAccuracy cameras;                                         // of the others, in this frame
};

// Compares views with the images of the same names in a true model; the others do not count. The
// frame is that of FindGauge by the rays of the views, for a scene around `middle` in their world.
// Throws IoError, also for fewer than three common images.
TrueFrame FindTrueFrame(const std::vector<View>& views, const std::string& true_model_path,
                        const Eigen::Vector3d& middle);

}  // namespace limn::colmap_ext
