#pragma once

#include <string>
#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A view whose camera does not fit the points of the sparse model.
struct Misfit {
  ViewId view = -1;
  double px = 0;  // see MedianReprojectionErrors
};

// What the points of the sparse model tell of the cameras.
struct CameraCheck {
  std::vector<Misfit> misfits;  // worst first
  int num_fits = 0;             // the other views that see enough points
  double fits_px = 0;           // their median error
};

// Compares every camera with the points that it sees: those that they miss by more than `max_px`
// in the median are misfits. Views that see too few points are neither.
CameraCheck CheckCameras(const std::vector<View>& views, const SceneHints& hints, double max_px);

// "2 of 24 images by more than 2 px: b.jpg (52 px), a.jpg (3 px); the other 22: 0.12 px".
// Precondition: there are misfits.
std::string Describe(const CameraCheck& check, const std::vector<View>& views, double max_px);

}  // namespace limn::colmap_ext
