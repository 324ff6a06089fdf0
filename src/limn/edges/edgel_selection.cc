#include "limn/edges/edgel_selection.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double kMinDistancePx = 0.35;

}  // namespace

EdgelRaster::EdgelRaster(int width, int height)
    : width_(width), height_(height), index_of_pixel_(static_cast<size_t>(width) * height, -1) {}

bool EdgelRaster::TryAdd(const Edgel& edgel) {
  const int x = static_cast<int>(std::lround(edgel.position_px.x()));
  const int y = static_cast<int>(std::lround(edgel.position_px.y()));
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
  int& cell = index_of_pixel_[static_cast<size_t>(y) * width_ + x];
  if (cell >= 0) return false;
  for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
      const int other = index_of_pixel_[static_cast<size_t>(v) * width_ + u];
      if (other < 0) continue;
      const Eigen::Vector2d offset = edgels_[other].position_px - edgel.position_px;
      if (offset.norm() < kMinDistancePx) return false;
    }
  }
  cell = static_cast<int>(edgels_.size());
  edgels_.push_back(edgel);
  return true;
}

bool EdgelRaster::HasParallelNear(double x, double y, double tangent_rad, double radius_px,
                                  double max_angle_rad) const {
  const int x0 = std::max(0, static_cast<int>(std::lround(x - radius_px)));
  const int y0 = std::max(0, static_cast<int>(std::lround(y - radius_px)));
  const int x1 = std::min(width_ - 1, static_cast<int>(std::lround(x + radius_px)));
  const int y1 = std::min(height_ - 1, static_cast<int>(std::lround(y + radius_px)));
  for (int v = y0; v <= y1; ++v) {
    for (int u = x0; u <= x1; ++u) {
      const int other = index_of_pixel_[static_cast<size_t>(v) * width_ + u];
      if (other < 0) continue;
      const Edgel& edgel = edgels_[other];
      const Eigen::Vector2d offset = edgel.position_px - Eigen::Vector2d(x, y);
      const double angle = std::abs(std::remainder(edgel.tangent_rad - tangent_rad, M_PI));
      if (offset.norm() <= radius_px && angle <= max_angle_rad) return true;
    }
  }
  return false;
}

std::vector<Edgel> EdgelRaster::InPixelOrder() const {
  std::vector<Edgel> ordered;
  ordered.reserve(edgels_.size());
  for (const int index : index_of_pixel_) {
    if (index >= 0) ordered.push_back(edgels_[index]);
  }
  return ordered;
}

void SortByStrength(std::vector<Edgel>* edgels) {
  std::sort(edgels->begin(), edgels->end(), [](const Edgel& a, const Edgel& b) {
    if (a.strength != b.strength) return a.strength > b.strength;
    if (a.position_px.y() != b.position_px.y()) return a.position_px.y() < b.position_px.y();
    return a.position_px.x() < b.position_px.x();
  });
}

}  // namespace limn
