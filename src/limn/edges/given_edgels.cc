// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/given_edgels.h"

#include <algorithm>
#include <cmath>

#include "limn/edges/edgel_selection.h"

namespace limn {
namespace {

constexpr int kMaxEdgelsOfPixel = 8;

// The index of its pixel, or of the nearest in the image.
size_t PixelOf(const EdgeMap& edge_map, const Edgel& edgel) {
  const auto x = std::clamp<long>(std::lround(edgel.position_px.x()), 0, edge_map.width - 1);
  const auto y = std::clamp<long>(std::lround(edgel.position_px.y()), 0, edge_map.height - 1);
  return static_cast<size_t>(y) * edge_map.width + x;
}

EdgelRaster RasterOf(const EdgeMap& edge_map) {
  std::vector<RefinedEdgel> edgels;
  edgels.reserve(edge_map.edgels.size());
  for (const Edgel& edgel : edge_map.edgels) edgels.push_back({edgel});
  EdgelRaster raster(edge_map.width, edge_map.height);
  raster.AddStrongestFirst(edgels);
  return raster;
}

}  // namespace

void ResizeEdgeMap(int width, int height, EdgeMap* edge_map) {
  if (edge_map->width == width && edge_map->height == height) return;
  const Eigen::Vector2d scale(width / static_cast<double>(edge_map->width),
                              height / static_cast<double>(edge_map->height));
  for (Edgel& edgel : edge_map->edgels) {
    edgel.position_px = ResizedPlace(edgel.position_px, scale);
    edgel.stored_px = edgel.position_px.cast<float>();
    const Eigen::Vector2d tangent = edgel.Tangent().cwiseProduct(scale);
    edgel.tangent_rad = std::atan2(tangent.y(), tangent.x());
    edgel.position_sigma_px *= static_cast<float>(std::sqrt(scale.prod()));
  }
  edge_map->width = width;
  edge_map->height = height;
}

void SetUnknownSigmas(EdgeMap* edge_map) {
  for (Edgel& edgel : edge_map->edgels) {
    if (edgel.position_sigma_px == 0) edgel.position_sigma_px = kUnknownSigmaPx;
  }
}

void ThinEdgels(EdgeMap* edge_map) { edge_map->edgels = RasterOf(*edge_map).Edgels(); }

void MarkTexture(double min_density, EdgeMap* edge_map) {
  edge_map->texture = RasterOf(*edge_map).Texture(min_density);
}

std::vector<bool> OutsideCrowds(const EdgeMap& edge_map) {
  std::vector<int> num_of_pixel(static_cast<size_t>(edge_map.width) * edge_map.height, 0);
  std::vector<bool> outside;
  for (const Edgel& edgel : edge_map.edgels) {
    outside.push_back(++num_of_pixel[PixelOf(edge_map, edgel)] <= kMaxEdgelsOfPixel);
  }
  return outside;
}

std::vector<bool> OutsideMask(const EdgeMap& edge_map, const std::vector<unsigned char>& mask) {
  std::vector<bool> outside(edge_map.edgels.size(), true);
  if (mask.empty()) return outside;
  for (size_t i = 0; i < outside.size(); ++i) {
    outside[i] = mask[PixelOf(edge_map, edge_map.edgels[i])] != 0;
  }
  return outside;
}

}  // namespace limn
