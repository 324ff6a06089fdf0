#pragma once

#include <vector>

#include "limn/model/edge_map.h"

namespace limn {

// What edgels of other programs need before they take part like detected ones. Each function leaves
// edgels of this program, found in the same image, as they are. Linear time.

// Standard deviation of the position of edgels whose file does not tell it: that of a pixel.
constexpr float kUnknownSigmaPx = 0.29f;

// Where a place of an image is in the same one `scale` times as large: the corners of the images
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

// Makes the edgels what linking takes for granted, those of an EdgelRaster: at most one per pixel
// of the image, none within 0.35 px of another, in row-major order. The stronger stays; edgels
// outside the image are dropped.
void ThinEdgels(EdgeMap* edge_map);

// Tells the texture of edgels that ThinEdgels made, as DetectEdges does.
void MarkTexture(double min_density, EdgeMap* edge_map);

// By edgel: whether it is one of the first 8 of its pixel. Curves from elsewhere may run over each
// other, but what is given many times over must not take the time of the whole image.
std::vector<bool> OutsideCrowds(const EdgeMap& edge_map);

// By edgel: whether its pixel, or the nearest in the image, is nonzero in the mask: one byte per
// pixel, or empty = all are.
std::vector<bool> OutsideMask(const EdgeMap& edge_map, const std::vector<unsigned char>& mask);

}  // namespace limn
