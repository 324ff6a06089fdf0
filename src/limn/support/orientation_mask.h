#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/edge_map.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"

namespace limn {

// A raster over the virtual image that answers "is there an edgel near here with this direction?"
// with one memory access: 16 orientation bins of 11.25 degrees per pixel. Rounds to a pixel and a
// bin, so it is for counting many hypotheses; EdgelIndex gives the exact edgel.
class OrientationMask {
 public:
  static constexpr int kNumBins = 16;

  OrientationMask(const EdgeMap& edge_map, const std::vector<bool>& usable,
                  const ImageRegion& region, const SupportGate& gate);

  // Direction (dx, dy) need not be normalised.
  bool Supports(double x, double y, double dx, double dy) const {
    const int col = static_cast<int>(x - origin_.x() + 0.5);
    const int row = static_cast<int>(y - origin_.y() + 0.5);
    if (col < 0 || row < 0 || col >= cols_ || row >= rows_) return false;
    return (bits_[static_cast<size_t>(row) * cols_ + col] >> Bin(dx, dy)) & 1;
  }

  // The bin of an undirected direction.
  static int Bin(double dx, double dy);

 private:
  void Draw(const Edgel& edgel, const SupportGate& gate);

  Eigen::Vector2d origin_;
  int cols_ = 0;
  int rows_ = 0;
  std::vector<uint16_t> bits_;
};

}  // namespace limn
