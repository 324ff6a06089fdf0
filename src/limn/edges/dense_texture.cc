// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/dense_texture.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int kCellPx = 4;
// Of the neighborhood, in cells.
constexpr int kReach = 2;
constexpr float kNeighborhoodPx2 = (2 * kReach + 1) * kCellPx * (2 * kReach + 1) * kCellPx;
constexpr double kShortRunPx = 12;
constexpr float kMinShortShare = 0.5F;
constexpr float kMaxCoherence = 0.45F;

// Sums over edgels.
struct Directions {
  float count = 0;
  float num_short = 0;
  float cosine = 0;  // of twice the angle
  float sine = 0;

  void Add(const Directions& other) {
    count += other.count;
    num_short += other.num_short;
    cosine += other.cosine;
    sine += other.sine;
  }
};

bool IsTexture(const Directions& around, double min_density) {
  return around.num_short >= static_cast<float>(min_density) * kNeighborhoodPx2 &&
         around.num_short >= kMinShortShare * around.count &&
         std::hypot(around.cosine, around.sine) < kMaxCoherence * around.count;
}

class CellSums {
 public:
  CellSums(int width, int height)
      : cols_((width + kCellPx - 1) / kCellPx), rows_((height + kCellPx - 1) / kCellPx) {
    cells_.resize(static_cast<size_t>(cols_) * rows_);
  }

  size_t CellAt(const Eigen::Vector2d& px) const {
    const auto place = [](double value, int count) {
      return std::clamp(static_cast<int>(value / kCellPx), 0, count - 1);
    };
    return static_cast<size_t>(place(px.y(), rows_)) * cols_ + place(px.x(), cols_);
  }

  Directions& operator[](size_t cell) { return cells_[cell]; }

  // Per cell, the sum over its neighborhood.
  std::vector<Directions> Around() const {
    std::vector<Directions> along_rows(cells_.size());
    std::vector<Directions> around(cells_.size());
    for (int row = 0; row < rows_; ++row) {
      for (int col = 0; col < cols_; ++col) {
        for (int c = std::max(0, col - kReach); c <= std::min(cols_ - 1, col + kReach); ++c) {
          along_rows[Index(row, col)].Add(cells_[Index(row, c)]);
        }
      }
    }
    for (int row = 0; row < rows_; ++row) {
      for (int r = std::max(0, row - kReach); r <= std::min(rows_ - 1, row + kReach); ++r) {
        for (int col = 0; col < cols_; ++col) {
          around[Index(row, col)].Add(along_rows[Index(r, col)]);
        }
      }
    }
    return around;
  }

 private:
  size_t Index(int row, int col) const { return static_cast<size_t>(row) * cols_ + col; }

  int cols_;
  int rows_;
  std::vector<Directions> cells_;
};

}  // namespace

std::vector<EdgelId> FindDenseTexture(const std::vector<TextureSample>& edgels, int width,
                                      int height, double min_density) {
  std::vector<EdgelId> texture;
  if (min_density <= 0 || edgels.empty()) return texture;
  CellSums sums(width, height);
  std::vector<size_t> cell_of;
  cell_of.reserve(edgels.size());
  for (const TextureSample& edgel : edgels) {
    cell_of.push_back(sums.CellAt(edgel.position_px));
    const float x = static_cast<float>(edgel.tangent.x());
    const float y = static_cast<float>(edgel.tangent.y());
    sums[cell_of.back()].Add(
        {1, edgel.run_px < kShortRunPx ? 1.0F : 0.0F, x * x - y * y, 2 * x * y});
  }
  const std::vector<Directions> around = sums.Around();
  for (size_t i = 0; i < edgels.size(); ++i) {
    if (edgels[i].run_px >= kShortRunPx || !IsTexture(around[cell_of[i]], min_density)) continue;
    texture.push_back(static_cast<EdgelId>(i));
  }
  return texture;
}

}  // namespace limn
