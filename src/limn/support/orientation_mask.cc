// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/orientation_mask.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "limn/geometry/epipolar.h"

namespace limn {
namespace {

constexpr double kBinWidth = M_PI / OrientationMask::kNumBins;

uint16_t BinsNear(double angle_rad, double gate_rad) {
  uint16_t bins = 0;
  for (int bin = 0; bin < OrientationMask::kNumBins; ++bin) {
    if (UndirectedAngle(angle_rad, (bin + 0.5) * kBinWidth) <= gate_rad) bins |= 1u << bin;
  }
  return bins;
}

}  // namespace

int OrientationMask::Bin(double dx, double dy) {
  if (dy < 0) {
    dx = -dx;
    dy = -dy;
  }
  // atan(r) ~ r (pi/4 + 0.273 (1 - r)) on [0, 1], error below 0.004 rad: far below a bin.
  const double ax = std::abs(dx);
  const double low = std::min(ax, dy);
  const double high = std::max(ax, dy);
  if (!(high > 0)) return 0;
  const double ratio = low / high;
  double angle = ratio * (M_PI / 4 + 0.273 * (1 - ratio));
  if (dy > ax) angle = M_PI / 2 - angle;
  if (dx < 0) angle = M_PI - angle;
  return std::min(static_cast<int>(angle * (kNumBins / M_PI)), kNumBins - 1);
}

OrientationMask::OrientationMask(const EdgeMap& edge_map, const std::vector<bool>& usable,
                                 const ImageRegion& region, const SupportGate& gate)
    : origin_(region.min_px.array().floor()) {
  const Eigen::Vector2d extent = region.max_px - origin_;
  cols_ = std::max(1, static_cast<int>(std::ceil(extent.x())) + 1);
  rows_ = std::max(1, static_cast<int>(std::ceil(extent.y())) + 1);
  tile_cols_ = (cols_ + kTilePx - 1) / kTilePx;
  const int tile_rows = (rows_ + kTilePx - 1) / kTilePx;
  tile_begin_.assign(static_cast<size_t>(tile_cols_) * tile_rows, 0);
  bits_.assign(kTileSize, 0);
  for (size_t id = 0; id < edge_map.edgels.size(); ++id) {
    if (usable[id]) Draw(edge_map.edgels[id], gate);
  }
  bits_.shrink_to_fit();
}

uint16_t& OrientationMask::BitsAt(int col, int row) {
  uint32_t& begin = tile_begin_[TileOf(col, row)];
  if (begin == 0) {
    begin = static_cast<uint32_t>(bits_.size());
    bits_.resize(bits_.size() + kTileSize, 0);
  }
  return bits_[begin + PlaceInTile(col, row)];
}

void OrientationMask::Draw(const Edgel& edgel, const SupportGate& gate) {
  const uint16_t bins = BinsNear(edgel.tangent_rad, gate.angle_rad);
  const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
  const Eigen::Vector2d tangent = (stored_from_virtual * edgel.Tangent()).normalized();
  const Eigen::Matrix2d virtual_from_stored = stored_from_virtual.inverse();
  const double radius = std::hypot(gate.normal_px, gate.along_px);
  const Eigen::Vector2d half_size(virtual_from_stored.row(0).norm() * radius,
                                  virtual_from_stored.row(1).norm() * radius);
  const Eigen::Vector2d center = edgel.position_px - origin_;
  const int col_begin = std::max(0, static_cast<int>(std::ceil(center.x() - half_size.x())));
  const int col_end = std::min(cols_ - 1, static_cast<int>(center.x() + half_size.x()));
  const int row_begin = std::max(0, static_cast<int>(std::ceil(center.y() - half_size.y())));
  const int row_end = std::min(rows_ - 1, static_cast<int>(center.y() + half_size.y()));
  for (int row = row_begin; row <= row_end; ++row) {
    for (int col = col_begin; col <= col_end; ++col) {
      const Eigen::Vector2d offset = stored_from_virtual * (Eigen::Vector2d(col, row) - center);
      const double normal = tangent.y() * offset.x() - tangent.x() * offset.y();
      if (std::abs(normal) > gate.normal_px || std::abs(tangent.dot(offset)) > gate.along_px) {
        continue;
      }
      BitsAt(col, row) |= bins;
    }
  }
}

}  // namespace limn
