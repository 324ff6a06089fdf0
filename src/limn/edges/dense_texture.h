// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/edgel.h"

namespace limn {

// An edgel as FindDenseTexture needs it: position, direction, and how far its run extends
// (EdgelRaster).
struct TextureSample {
  Eigen::Vector2d position_px;
  Eigen::Vector2d tangent;  // unit
  double run_px = 0;
};

// The indices, ascending, of edgels of leaves and the like: those in runs shorter than 12 px where,
// in the 20 px around their cell of 4 px, such edgels are at least `min_density` per px^2 and half
// of all, and directions are mixed: |mean exp(2 i angle)| < 0.45. What crosses texture in longer
// runs is not texture. None if min_density is 0. Time: linear in edgels and cells.
//
// Such edgels match by chance in other views.
std::vector<EdgelId> FindDenseTexture(const std::vector<TextureSample>& edgels, int width,
                                      int height, double min_density);

}  // namespace limn
