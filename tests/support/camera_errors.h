#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn::testing {

// The views, each turned and moved at random such that the projections of the points move by
// `mean_px` in the mean over all views that see them. Precondition: some view sees some point.
std::vector<View> PerturbCameras(const std::vector<View>& views,
                                 const std::vector<Eigen::Vector3d>& points, double mean_px,
                                 unsigned seed);

// How far views are from the true ones, in the mean. Other than for `raw_px`, the world is first
// moved, turned and scaled such that the camera centres fit best.
struct CameraErrors {
  double raw_px = 0;      // displacement of the points' projections as they are
  double aligned_px = 0;  // the same after alignment
  double rotation_deg = 0;
  double center = 0;  // world units
};

// Points count in every view that truly sees them. Precondition: at least three centres, not on a
// line.
CameraErrors MeasureCameras(const std::vector<View>& views, const std::vector<View>& truth,
                            const std::vector<Eigen::Vector3d>& points);

}  // namespace limn::testing
