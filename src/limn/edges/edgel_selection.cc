#include "limn/edges/edgel_selection.h"

#include <algorithm>
#include <cmath>

#include "limn/util/union_find.h"

namespace limn {
namespace {

using Eigen::Vector2d;

constexpr double kMinDistancePx = 0.35;
constexpr double kRunStepPx = 2.0;
const double kRunMinCosine = std::cos(M_PI / 6);

// Does an edgel at `offset` with tangent `other` continue one with tangent `tangent`? The offset
// may leave the tangent by a third of a pixel plus 35 degrees.
bool Continues(const Vector2d& tangent, const Vector2d& offset, const Vector2d& other) {
  if (tangent.dot(other) < kRunMinCosine || offset.norm() > kRunStepPx) return false;
  const double along = std::abs(offset.dot(tangent));
  const double across = std::abs(tangent.x() * offset.y() - tangent.y() * offset.x());
  return across <= 0.3 + 0.7 * along;
}

bool StrongerThan(const RefinedEdgel& a, const RefinedEdgel& b) {
  if (a.edgel.strength != b.edgel.strength) return a.edgel.strength > b.edgel.strength;
  const Vector2d& p = a.edgel.position_px;
  const Vector2d& q = b.edgel.position_px;
  return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
}

}  // namespace

EdgelRaster::EdgelRaster(int width, int height)
    : width_(width), height_(height), index_of_pixel_(static_cast<size_t>(width) * height, -1) {}

template <typename Visit>
void EdgelRaster::VisitSquare(const Vector2d& center, double radius_px, const Visit& visit) const {
  const int x0 = std::max(0, static_cast<int>(std::lround(center.x() - radius_px)));
  const int y0 = std::max(0, static_cast<int>(std::lround(center.y() - radius_px)));
  const int x1 = std::min(width_ - 1, static_cast<int>(std::lround(center.x() + radius_px)));
  const int y1 = std::min(height_ - 1, static_cast<int>(std::lround(center.y() + radius_px)));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const int index = index_of_pixel_[static_cast<size_t>(y) * width_ + x];
      if (index >= 0) visit(index);
    }
  }
}

void EdgelRaster::AddStrongestFirst(std::vector<RefinedEdgel> edgels) {
  std::sort(edgels.begin(), edgels.end(), StrongerThan);
  for (const RefinedEdgel& edgel : edgels) TryAdd(edgel);
}

void EdgelRaster::TryAdd(const RefinedEdgel& refined) {
  const Vector2d& position = refined.edgel.position_px;
  const int x = static_cast<int>(std::lround(position.x()));
  const int y = static_cast<int>(std::lround(position.y()));
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  int& cell = index_of_pixel_[static_cast<size_t>(y) * width_ + x];
  if (cell >= 0) return;
  bool taken = false;
  VisitSquare(position, kMinDistancePx, [&](int other) {
    taken |= (edgels_[other].edgel.position_px - position).norm() < kMinDistancePx;
  });
  if (taken) return;
  cell = static_cast<int>(edgels_.size());
  edgels_.push_back(refined);
}

bool EdgelRaster::HasParallelNear(double x, double y, double tangent_rad, double radius_px,
                                  double max_angle_rad) const {
  const Vector2d center(x, y);
  bool found = false;
  VisitSquare(center, radius_px, [&](int other) {
    const Edgel& edgel = edgels_[other].edgel;
    const double angle = std::abs(std::remainder(edgel.tangent_rad - tangent_rad, M_PI));
    found |= (edgel.position_px - center).norm() <= radius_px && angle <= max_angle_rad;
  });
  return found;
}

void EdgelRaster::DropWeakShortRuns(double strong_ratio, double min_run_px) {
  const int count = static_cast<int>(edgels_.size());
  std::vector<Vector2d> tangents;
  for (const RefinedEdgel& refined : edgels_) tangents.push_back(refined.edgel.Tangent());
  UnionFind runs(count);
  for (int i = 0; i < count; ++i) {
    const Vector2d& position = edgels_[i].edgel.position_px;
    VisitSquare(position, kRunStepPx, [&](int other) {
      const Vector2d offset = edgels_[other].edgel.position_px - position;
      if (Continues(tangents[i], offset, tangents[other])) runs.Union(i, other);
    });
  }
  std::vector<Vector2d> low(count);
  std::vector<Vector2d> high(count);
  for (int i = 0; i < count; ++i) {
    // The representative is the smallest member, hence the first one seen.
    const Vector2d& position = edgels_[i].edgel.position_px;
    const int run = runs.Find(i);
    low[run] = run == i ? position : Vector2d(low[run].cwiseMin(position));
    high[run] = run == i ? position : Vector2d(high[run].cwiseMax(position));
  }
  for (int& cell : index_of_pixel_) {
    if (cell < 0 || edgels_[cell].significance >= strong_ratio) continue;
    const int run = runs.Find(cell);
    if ((high[run] - low[run]).norm() < min_run_px) cell = -1;
  }
}

std::vector<Edgel> EdgelRaster::InPixelOrder() const {
  std::vector<Edgel> ordered;
  ordered.reserve(edgels_.size());
  for (const int index : index_of_pixel_) {
    if (index >= 0) ordered.push_back(edgels_[index].edgel);
  }
  return ordered;
}

}  // namespace limn
