// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/edge_map.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"

namespace limn {

// A raster over the virtual image that answers "is there an edgel near here with this direction?"
// with two memory accesses: 16 orientation bins of 11.25 degrees per pixel, in tiles of which only
// those near edgels exist. It is accurate to a pixel and a bin, for testing many hypotheses;
// EdgelIndex finds the exact edgel. Memory: about 70 bytes per edgel and 1/16 byte per pixel.
class OrientationMask {
 public:
  static constexpr int kNumBins = 16;

  OrientationMask(const EdgeMap& edge_map, const std::vector<bool>& usable,
                  const ImageRegion& region, const SupportGate& gate);

  // Direction (dx, dy) need not be normalized.
  bool Supports(double x, double y, double dx, double dy) const {
    const int col = static_cast<int>(x - origin_.x() + 0.5);
    const int row = static_cast<int>(y - origin_.y() + 0.5);
    if (col < 0 || row < 0 || col >= cols_ || row >= rows_) return false;
    return (bits_[tile_begin_[TileOf(col, row)] + PlaceInTile(col, row)] >> Bin(dx, dy)) & 1;
  }

  // The bin of an undirected direction.
  static int Bin(double dx, double dy);

 private:
  static constexpr int kLogTilePx = 3;
  static constexpr int kTilePx = 1 << kLogTilePx;
  static constexpr uint32_t kTileSize = kTilePx * kTilePx;

  size_t TileOf(int col, int row) const {
    return static_cast<size_t>(row >> kLogTilePx) * tile_cols_ + (col >> kLogTilePx);
  }
  static uint32_t PlaceInTile(int col, int row) {
    return (row & (kTilePx - 1)) << kLogTilePx | (col & (kTilePx - 1));
  }
  void Draw(const Edgel& edgel, const SupportGate& gate);
  // Makes the tile of the pixel if there is none.
  uint16_t& BitsAt(int col, int row);

  Eigen::Vector2d origin_;
  int cols_ = 0;
  int rows_ = 0;
  int tile_cols_ = 0;
  std::vector<uint32_t> tile_begin_;  // per tile, row-major: its first pixel; 0 = the empty tile
  std::vector<uint16_t> bits_;        // tile by tile, pixels of a tile row-major
};

}  // namespace limn
