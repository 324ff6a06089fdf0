// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edgel_selection.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include "limn/edges/dense_texture.h"

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr double kMinDistancePx = 0.35;
constexpr double kRunStepPx = 2.0;
const double kRunMinCosine = std::cos(M_PI / 6);

// Does an edgel at `offset` follow one with tangent `tangent`? The offset may leave the tangent by
// a third of a pixel plus 35 degrees.
bool Follows(const Vector2d& tangent, const Vector2d& offset) {
  const double along = std::abs(offset.dot(tangent));
  const double across = std::abs(tangent.x() * offset.y() - tangent.y() * offset.x());
  return across <= 0.3 + 0.7 * along;
}

bool InOneRun(const EdgelPlace& a, const EdgelPlace& b) {
  const Vector2d offset = b.position - a.position;
  return a.tangent.dot(b.tangent) >= kRunMinCosine &&
         offset.squaredNorm() <= kRunStepPx * kRunStepPx &&
         (Follows(a.tangent, offset) || Follows(b.tangent, offset));
}

// Without the function call that std::floor is where SSE2 is all there is.
int NearestInt(double value) {
  const int towards_zero = static_cast<int>(value + 0.5);
  return towards_zero - (towards_zero > value + 0.5);
}

// Indices of edgels, the strongest first, ties in the given order.
std::vector<uint32_t> ByStrength(const std::vector<RefinedEdgel>& edgels) {
  // Bits of positive floats ascend with their values.
  std::vector<uint64_t> keys(edgels.size());
  for (size_t i = 0; i < edgels.size(); ++i) {
    keys[i] = static_cast<uint64_t>(~std::bit_cast<uint32_t>(edgels[i].edgel.strength)) << 32 | i;
  }
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  return {keys.begin(), keys.end()};
}

}  // namespace

EdgelRaster::EdgelRaster(int width, int height)
    : width_(width), height_(height), index_of_pixel_(static_cast<size_t>(width) * height, -1) {}

template <typename Test>
bool EdgelRaster::AnyInSquare(const Vector2d& center, double radius_px, const Test& test) const {
  const int x0 = std::max(0, NearestInt(center.x() - radius_px));
  const int y0 = std::max(0, NearestInt(center.y() - radius_px));
  const int x1 = std::min(width_ - 1, NearestInt(center.x() + radius_px));
  const int y1 = std::min(height_ - 1, NearestInt(center.y() + radius_px));
  for (int y = y0; y <= y1; ++y) {
    const int* row = index_of_pixel_.data() + static_cast<size_t>(y) * width_;
    for (int x = x0; x <= x1; ++x) {
      if (row[x] >= 0 && test(row[x])) return true;
    }
  }
  return false;
}

void EdgelRaster::AddStrongestFirst(const std::vector<RefinedEdgel>& edgels) {
  const int begin = static_cast<int>(edgels_.size());
  edgels_.insert(edgels_.end(), edgels.begin(), edgels.end());
  places_.reserve(edgels_.size());
  for (const RefinedEdgel& refined : edgels) {
    places_.push_back({refined.edgel.position_px, Vector2d::Zero()});
  }
  for (const uint32_t i : ByStrength(edgels)) TryHold(begin + static_cast<int>(i));
}

void EdgelRaster::TryHold(int index) {
  const Vector2d position = places_[index].position;
  const int x = NearestInt(position.x());
  const int y = NearestInt(position.y());
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  int& cell = index_of_pixel_[static_cast<size_t>(y) * width_ + x];
  if (cell >= 0) return;
  const bool taken = AnyInSquare(position, kMinDistancePx, [&](int other) {
    return (places_[other].position - position).squaredNorm() < kMinDistancePx * kMinDistancePx;
  });
  if (taken) return;
  cell = index;
  places_[index].tangent = edgels_[index].edgel.Tangent();
}

void EdgelRaster::Compact() {
  std::vector<RefinedEdgel> edgels;
  std::vector<EdgelPlace> places;
  edgels.reserve(edgels_.size());
  places.reserve(edgels_.size());
  for (int& cell : index_of_pixel_) {
    if (cell < 0) continue;
    edgels.push_back(edgels_[cell]);
    places.push_back(places_[cell]);
    cell = static_cast<int>(edgels.size()) - 1;
  }
  edgels_ = std::move(edgels);
  places_ = std::move(places);
}

bool EdgelRaster::HasParallelNear(const Vector2d& position, const Vector2d& direction,
                                  double radius_px, double min_cosine) const {
  const double squared_radius = radius_px * radius_px;
  const double min_product = min_cosine * direction.norm();
  const auto parallel_near = [&](int other) {
    return (places_[other].position - position).squaredNorm() <= squared_radius &&
           std::abs(places_[other].tangent.dot(direction)) >= min_product;
  };
  // Mostly the nearest pixels tell.
  return AnyInSquare(position, std::min(1.0, radius_px), parallel_near) ||
         AnyInSquare(position, radius_px, parallel_near);
}

bool EdgelRaster::HasOppositeNear(const Edgel& edgel, double radius_px, double min_cosine,
                                  double min_ratio) const {
  const Vector2d opposite = -edgel.Tangent();
  return AnyInSquare(edgel.position_px, radius_px, [&](int other) {
    const auto& [position, tangent] = places_[other];
    return (position - edgel.position_px).squaredNorm() <= radius_px * radius_px &&
           tangent.dot(opposite) >= min_cosine &&
           edgels_[other].edgel.strength >= min_ratio * edgel.strength;
  });
}

UnionFind EdgelRaster::Runs() const {
  // Positions within kRunStepPx are in pixels at most so far apart.
  constexpr int kReach = 2;
  static_assert(kReach >= kRunStepPx);
  UnionFind runs(static_cast<int>(edgels_.size()));
  for (int y = 0; y < height_; ++y) {
    const int* row = index_of_pixel_.data() + static_cast<size_t>(y) * width_;
    for (int x = 0; x < width_; ++x) {
      if (row[x] < 0) continue;
      // Every pair once: the pixels to the right and below.
      for (int v = 0; v <= std::min(kReach, height_ - 1 - y); ++v) {
        const int* other = row + static_cast<std::ptrdiff_t>(v) * width_;
        for (int u = v == 0 ? x + 1 : std::max(0, x - kReach);
             u <= std::min(width_ - 1, x + kReach); ++u) {
          if (other[u] >= 0 && InOneRun(places_[row[x]], places_[other[u]])) {
            runs.Union(row[x], other[u]);
          }
        }
      }
    }
  }
  return runs;
}

std::vector<double> EdgelRaster::RunLengths() const {
  UnionFind runs = Runs();
  struct Box {
    Vector2d low = Vector2d::Constant(std::numeric_limits<double>::max());
    Vector2d high = -low;
  };
  std::vector<Box> box_of(edgels_.size());  // of a run, by its representative
  for (const int cell : index_of_pixel_) {
    if (cell < 0) continue;
    Box& box = box_of[runs.Find(cell)];
    box.low = box.low.cwiseMin(places_[cell].position);
    box.high = box.high.cwiseMax(places_[cell].position);
  }
  std::vector<double> lengths(edgels_.size(), 0);
  for (const int cell : index_of_pixel_) {
    if (cell < 0) continue;
    const Box& box = box_of[runs.Find(cell)];
    lengths[cell] = (box.high - box.low).norm();
  }
  return lengths;
}

void EdgelRaster::DropWeakShortRuns(double strong_ratio, double min_run_px) {
  const std::vector<double> run_px = RunLengths();
  for (int& cell : index_of_pixel_) {
    if (cell < 0) continue;
    if (edgels_[cell].significance < strong_ratio && run_px[cell] < min_run_px) cell = -1;
  }
  Compact();
}

std::vector<EdgelId> EdgelRaster::Texture(double min_density) const {
  if (min_density == 0) return {};
  const std::vector<double> run_px = RunLengths();
  std::vector<TextureSample> samples;
  samples.reserve(edgels_.size());
  for (const int cell : index_of_pixel_) {
    if (cell >= 0) samples.push_back({places_[cell].position, places_[cell].tangent, run_px[cell]});
  }
  return FindDenseTexture(samples, width_, height_, min_density);
}

std::vector<Edgel> EdgelRaster::Edgels() const {
  std::vector<Edgel> edgels;
  edgels.reserve(edgels_.size());
  for (const int cell : index_of_pixel_) {
    if (cell >= 0) edgels.push_back(edgels_[cell].edgel);
  }
  return edgels;
}

}  // namespace limn
