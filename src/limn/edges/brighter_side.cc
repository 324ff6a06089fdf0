// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/brighter_side.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr int kVotePx = 3;
constexpr double kMaxVoteOffsetPx = 1;  // across
const double kVoteMinCosine = std::cos(M_PI / 6);

// The edgels of an image by cells of kVotePx, so that neighbors are in adjacent cells.
class VoteCells {
 public:
  VoteCells(const Image& image, const std::vector<Edgel>& edgels)
      : cols_(image.width / kVotePx + 1),
        rows_(image.height / kVotePx + 1),
        cells_(static_cast<size_t>(cols_) * rows_) {
    for (size_t i = 0; i < edgels.size(); ++i) {
      const auto [col, row] = CellOf(edgels[i].position_px);
      cells_[static_cast<size_t>(row) * cols_ + col].push_back(i);
    }
  }

  template <typename Visit>
  void VisitAround(const Vector2d& px, const Visit& visit) const {
    const auto [col, row] = CellOf(px);
    for (int v = std::max(0, row - 1); v <= std::min(rows_ - 1, row + 1); ++v) {
      for (int u = std::max(0, col - 1); u <= std::min(cols_ - 1, col + 1); ++u) {
        for (const size_t i : cells_[static_cast<size_t>(v) * cols_ + u]) visit(i);
      }
    }
  }

 private:
  std::pair<int, int> CellOf(const Vector2d& px) const {
    return {std::clamp(static_cast<int>(px.x() / kVotePx), 0, cols_ - 1),
            std::clamp(static_cast<int>(px.y() / kVotePx), 0, rows_ - 1)};
  }

  int cols_;
  int rows_;
  std::vector<std::vector<size_t>> cells_;
};

// 1 or -1 if the other continues the edgel with the same or the opposite tangent, else 0.
int Vote(const Edgel& edgel, const Edgel& other) {
  const Vector2d offset = other.position_px - edgel.position_px;
  const double cosine = edgel.Tangent().dot(other.Tangent());
  if (offset.squaredNorm() > kVotePx * kVotePx) return 0;
  if (std::abs(offset.dot(edgel.Normal())) > kMaxVoteOffsetPx) return 0;
  return cosine >= kVoteMinCosine ? 1 : cosine <= -kVoteMinCosine ? -1 : 0;
}

}  // namespace

double BrighterSide(const Image& image, const Edgel& edgel) {
  const Vector2d normal = edgel.Normal();
  double difference = 0;
  for (const double distance : {1.0, 2.0, 3.0}) {
    difference += (ColorAt(image, edgel.position_px + distance * normal) -
                   ColorAt(image, edgel.position_px - distance * normal))
                      .mean();
  }
  return difference / 3;
}

void DirectByBrightness(const Image& image, std::vector<Edgel>* edgels) {
  std::vector<double> sides;
  for (const Edgel& edgel : *edgels) sides.push_back(BrighterSide(image, edgel));
  const VoteCells cells(image, *edgels);
  std::vector<bool> turn;
  for (const Edgel& edgel : *edgels) {
    double sum = 0;
    cells.VisitAround(edgel.position_px,
                      [&](size_t i) { sum += Vote(edgel, (*edgels)[i]) * sides[i]; });
    turn.push_back(sum < 0);
  }
  for (size_t i = 0; i < turn.size(); ++i) {
    if (turn[i]) (*edgels)[i].Turn();
  }
}

}  // namespace limn
