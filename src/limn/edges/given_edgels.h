// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edge_map.h"

namespace limn {

// Prepares edgels of other programs so that they can be used like detected ones. Each function
// leaves edgels that Limn found in the same image as they are. Linear time.

// Standard deviation of the position of edgels whose file does not give it: that of rounding to
// pixels.
constexpr float kUnknownSigmaPx = 0.29f;

// The position of a pixel in the same image `scale` times as large: the corners of the images
// coincide, and centers of pixels have whole coordinates.
inline Eigen::Vector2d ResizedPlace(const Eigen::Vector2d& px, const Eigen::Vector2d& scale) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  return (px + half).cwiseProduct(scale) - half;
}

// Moves edgels of an image of another size to one of width x height, both positive: positions
// (ResizedPlace), tangents and sigmas.
void ResizeEdgeMap(int width, int height, EdgeMap* edge_map);

// Gives those with sigma 0 kUnknownSigmaPx.
void SetUnknownSigmas(EdgeMap* edge_map);

// Gives the edgels the properties that linking assumes, those of an EdgelRaster: at most one per
// pixel of the image, none within 0.35 px of another, in row-major order. The stronger stays;
// edgels outside the image are dropped.
void ThinEdgels(EdgeMap* edge_map);

// Marks texture among edgels made by ThinEdgels, as DetectEdges does.
void MarkTexture(double min_density, EdgeMap* edge_map);

// By edgel: whether it is one of the first 8 of its pixel. Given curves may run over each other,
// but many copies must not cost as much time as the whole image.
std::vector<bool> OutsideCrowds(const EdgeMap& edge_map);

// By edgel: whether its pixel, or the nearest in the image, is nonzero in the mask: one byte per
// pixel, or empty = all are.
std::vector<bool> OutsideMask(const EdgeMap& edge_map, const std::vector<unsigned char>& mask);

}  // namespace limn
