// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include <Eigen/Core>

#include "limn/model/image.h"
#include "limn/model/view.h"

namespace limn {

// A small picture of a view's virtual pinhole image.
struct Thumbnail {
  // The rectangle of the virtual image that it covers, from edge to edge (the top-left pixel begins
  // at (-0.5, -0.5)), px.
  Eigen::Vector2d min_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d max_px = Eigen::Vector2d::Zero();
  std::string jpeg;  // a whole JPEG file
  // Of the longer side of the JPEG, pixels.
  int longer_side = 0;
};

struct ThumbnailOptions {
  // Most pixels of the longer side, >= 16.
  int longer_side = 1024;
  // The picture is shrunk further until its file has at most so many, or 16 pixels are left.
  size_t max_bytes = std::numeric_limits<size_t>::max();
};

// The photograph, undistorted if the view has a lens, shrunk, never enlarged. With a lens it covers
// the view's region, at most twice the image's size to each side of its middle (wide lenses reach
// very far), black outside the photograph. Throws InputError if the photograph does not have the
// size of the view's camera.
Thumbnail MakeThumbnail(const Image& photo, const View& view, const ThumbnailOptions& options);

// The photograph as it is stored, shrunk in the same way: a whole JPEG file.
std::string SmallJpeg(const Image& photo, int longer_side);

}  // namespace limn
