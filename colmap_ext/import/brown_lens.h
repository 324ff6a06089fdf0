// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "colmap_ext/model/camera_model.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

// From the pinhole's position (x, y) over the focal length, u = x^2 + y^2, to the picture's:
//   x (1 + k[0] u + k[1] u^2 + k[2] u^3 + k[3] u^4) + 2 p1 x y + p2 (u + 2 x^2), and
//   y (1 + ...) + 2 p2 x y + p1 (u + 2 y^2), as OpenCV names p1 and p2.
struct BrownLens {
  std::array<double, 4> k = {};
  double p1 = 0;
  double p2 = 0;
};

// Gives a PINHOLE camera this lens: it stays PINHOLE, or becomes OPENCV or FULL_OPENCV. The latter
// has no k[3]: it is fitted with one within 0.01 px, or the lens is refused via `place`.
void SetBrownLens(const BrownLens& lens, const FilePlace& place, Camera* camera);

// A PINHOLE camera of a fisheye lens, whose positions are over the focal length, too, but of length
// theta, the angle from the axis; then as above. It becomes OPENCV_FISHEYE, or THIN_PRISM_FISHEYE
// if p1 or p2 is not zero.
void SetFisheyeLens(const BrownLens& lens, Camera* camera);

}  // namespace limn::colmap_ext
