// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limn/model/view.h"

namespace limn::testing {

// The views, each turned and moved at random such that the projections of the points move by
// `mean_px` on average over all views that see them. Precondition: some view sees some point.
std::vector<View> PerturbCameras(const std::vector<View>& views,
                                 const std::vector<Eigen::Vector3d>& points, double mean_px,
                                 unsigned seed);

// The similarity that maps the true world to that of the views such that the camera centers fit
// best (least squares). Precondition: at least three centers, not on a line.
Eigen::Affine3d WorldFromTruth(const std::vector<View>& views, const std::vector<View>& truth);

// How far views are from the true ones, on average. Unlike for `raw_px`, the world is first moved,
// turned and scaled such that the camera centers fit best.
struct CameraErrors {
  double raw_px = 0;      // displacement of the points' projections as they are
  double aligned_px = 0;  // the same after alignment
  double rotation_deg = 0;
  double center = 0;  // world units
};

// Points count in every view that truly sees them. Precondition as for WorldFromTruth.
CameraErrors MeasureCameras(const std::vector<View>& views, const std::vector<View>& truth,
                            const std::vector<Eigen::Vector3d>& points);

}  // namespace limn::testing
