// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// Where the 2D points of an image are: pixel of the camera = (2D point - shift) / scale, in
// COLMAP's pixels. Programs that resize, pad or crop photographs for a network may store what they
// found there.
struct PointFrame {
  Eigen::Array2d scale = Eigen::Array2d::Ones();
  Eigen::Array2d shift = Eigen::Array2d::Zero();

  Eigen::Vector2d CameraPixel(const Eigen::Vector2d& point) const {
    return ((point.array() - shift) / scale).matrix();
  }
};

// By index into model.images.
using PointFrames = std::unordered_map<int, PointFrame>;

// The frames of those of these images (indices into model.images) whose 2D points are not pixels of
// the camera, but pixels of a picture of another size: they miss where the camera sees the 3D
// points by more than `doubtful_px` in the median, fit within that and five times better after
// scaling and moving each axis, and this is not what a wrong focal length does (which scales about
// the principal point, in the image) or a wrong principal point (which only moves). Most images of
// a size must have the same frame, and there must be three of them, or points outside the images.
// Images with fewer than ten points are not judged. Time: n log n in the number of points.
PointFrames FindPointFrames(const SparseModel& model, const std::vector<int>& images,
                            double doubtful_px);

// For the user: "the 2D points of 24 of 24 images are ...". Precondition: there are frames.
std::string DescribeFrames(const PointFrames& frames, const SparseModel& model, size_t num_images);

}  // namespace limn::colmap_ext
