#pragma once

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
};

// The photograph, undistorted if the view has a lens, shrunk (never enlarged) such that its longer
// side has `longer_side` >= 16 pixels. With a lens it covers the view's region, at most twice the
// image's size to each side of its middle (wide lenses reach very far), black outside the
// photograph. Throws InputError if the photograph does not have the size of the view's camera.
Thumbnail MakeThumbnail(const Image& photo, const View& view, int longer_side);

}  // namespace limn
