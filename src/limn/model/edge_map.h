// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edgel.h"
#include "limn/model/lens_map.h"

namespace limn {

// The edgels of one image, in row-major order of the pixel that holds them.
struct EdgeMap {
  // Size of the image as stored (after --max_image_size), pixels.
  int width = 0;
  int height = 0;
  std::vector<Edgel> edgels;
  // Edgels of dense texture, ascending: they are in no fragment (edges/dense_texture.h).
  std::vector<EdgelId> texture;
  // Standard deviation of one component of the smoothed gradient due to noise, gray levels per
  // pixel.
  double gradient_noise = 0;
  // Edgels that could not be mapped: outside the lens model's valid range.
  int num_outside_lens = 0;
};

// Whether a place is in an image of this size, or within a pixel of it: lenses, and programs that
// round, place edgels there.
inline bool IsNearImage(int width, int height, const Eigen::Vector2d& px) {
  return px.x() >= -1 && px.x() <= width && px.y() >= -1 && px.y() <= height;
}

// Maps edgels from stored pixels to the virtual pinhole image: position, tangent and Jacobian. Ids
// stay valid: an edgel that the lens cannot map (outside its valid range) stays in the map with
// strength 0 and is counted in num_outside_lens. Returns, per id, whether it was mapped. A null
// lens only fills stored_px.
std::vector<bool> ApplyLens(const LensMap* lens, EdgeMap* edge_map);

}  // namespace limn
