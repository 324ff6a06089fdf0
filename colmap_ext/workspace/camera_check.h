// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace limn::colmap_ext {

struct ViewSet;

// An image whose camera does not fit the points of the sparse model.
struct Misfit {
  std::string image;
  double px = 0;  // see MedianReprojectionErrors
};

// What the points of the sparse model say about the cameras.
struct CameraCheck {
  std::vector<Misfit> misfits;  // worst first
  int num_images = 0;
  int num_fits = 0;    // the other images that see enough points
  double fits_px = 0;  // their median error
};

// Compares the camera of every image, the parts of a panorama together, with the points that it
// sees: cameras whose points are off by more than `max_px` in the median are misfits. Images that
// see too few points are neither.
CameraCheck CheckCameras(const ViewSet& set, double max_px);

// "2 of 24 images by more than 2 px: b.jpg (52 px), a.jpg (3 px); the other 22: 0.12 px".
// Precondition: there are misfits.
std::string Describe(const CameraCheck& check, double max_px);

}  // namespace limn::colmap_ext
