// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/view_neighbors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "limn/geometry/angle_between.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kGridCols = 4;
constexpr int kGridRows = 3;
// Number of depths at which overlap is tested.
constexpr int kNumProbeDepths = 6;
// Octaves of distance; the last holds all that is nearer.
constexpr int kNumRings = 10;
constexpr int kMaxPerRing = NeighborFinder::kMaxNeighbors / kNumRings;
// Number of views of a ring that are tested for overlap.
constexpr size_t kMaxAskedPerRing = 8 * kMaxPerRing;
// Distance of the farthest neighbor in far depths.
constexpr double kReach = 3;
// Number of nearest cameras from which depths are estimated where there are no points, and ratio of
// near to far depth.
constexpr int kNumNearest = 128;
constexpr double kNearShare = 1.0 / 16;

using Ring = std::vector<SpatialIndex::Neighbor>;

// Every n-th, so that at most `max_size` remain.
template <typename T>
void Thin(size_t max_size, std::vector<T>* items) {
  const size_t size = items->size();
  if (size <= max_size) return;
  for (size_t i = 0; i < max_size; ++i) (*items)[i] = (*items)[i * size / max_size];
  items->resize(max_size);
}

// By ascending distance, without what is at the center itself.
std::array<Ring, kNumRings> MakeRings(const std::vector<SpatialIndex::Neighbor>& found,
                                      double reach) {
  std::array<Ring, kNumRings> rings;
  for (const SpatialIndex::Neighbor& other : found) {
    if (!(other.squared_distance > 0)) continue;
    const double octave = std::log2(reach / std::sqrt(other.squared_distance));
    rings[std::clamp(static_cast<int>(octave), 0, kNumRings - 1)].push_back(other);
  }
  for (Ring& ring : rings) {
    std::sort(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
      return std::pair(a.squared_distance, a.index) < std::pair(b.squared_distance, b.index);
    });
  }
  return rings;
}

std::vector<double> ProbeDepths(const DepthSpan& span) {
  std::vector<double> depths;
  for (int k = 0; k < kNumProbeDepths; ++k) {
    depths.push_back(span.near * std::pow(span.far / span.near, k / (kNumProbeDepths - 1.0)));
  }
  return depths;
}

std::vector<Eigen::Vector3d> CentersInWorld(const std::vector<View>& views) {
  std::vector<Eigen::Vector3d> centers;
  for (const View& view : views) centers.push_back(view.CenterInWorld());
  return centers;
}

std::vector<ViewId> AllBut(ViewId view, size_t num_views) {
  std::vector<ViewId> others;
  for (size_t v = 0; v < num_views; ++v) {
    if (static_cast<ViewId>(v) != view) others.push_back(static_cast<ViewId>(v));
  }
  return others;
}

}  // namespace

NeighborFinder::NeighborFinder(const std::vector<View>& views, double min_angle_deg,
                               double max_angle_deg)
    : views_(views),
      centers_(CentersInWorld(views)),
      min_angle_deg_(min_angle_deg),
      max_angle_deg_(max_angle_deg),
      index_(centers_) {}

std::vector<ViewId> NeighborFinder::Find(ViewId view,
                                         const std::optional<DepthSpan>& depths) const {
  if (views_.size() <= kSmallScene) return AllBut(view, views_.size());
  const DepthSpan span = depths ? *depths : SpanOfCameras(view);
  const std::vector<Eigen::Vector3d> places = PlacesInFront(views_[view], ProbeDepths(span));
  std::vector<SpatialIndex::Neighbor> found;
  index_.FindWithin(centers_[view], kReach * span.far, &found);
  std::vector<ViewId> neighbors;
  for (Ring& ring : MakeRings(found, kReach * span.far)) {
    Thin(kMaxAskedPerRing, &ring);
    std::erase_if(ring, [&](const auto& other) { return !SeesAny(other.index, view, places); });
    Thin(kMaxPerRing, &ring);
    for (const SpatialIndex::Neighbor& other : ring) neighbors.push_back(other.index);
  }
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

DepthSpan NeighborFinder::SpanOfCameras(ViewId view) const {
  std::vector<SpatialIndex::Neighbor> nearest;
  index_.FindNearest(centers_[view], kNumNearest, &nearest);
  std::vector<Eigen::Vector3d> centers;
  for (const SpatialIndex::Neighbor& other : nearest) centers.push_back(centers_[other.index]);
  double far = Extent(centers);
  // Many photographs from one place.
  if (!(far > 1e-9 * centers_[view].norm())) far = Extent(centers_);
  return {kNearShare * far, far};
}

bool NeighborFinder::SeesAny(ViewId other, ViewId view,
                             const std::vector<Eigen::Vector3d>& places) const {
  return std::any_of(places.begin(), places.end(), [&](const Eigen::Vector3d& place) {
    if (!views_[other].Project(place)) return false;
    const double angle = AngleBetween(place - centers_[view], place - centers_[other]) / kDeg;
    return angle >= min_angle_deg_ && angle <= max_angle_deg_;
  });
}

std::vector<Eigen::Vector3d> PlacesInFront(const View& view, const std::vector<double>& depths) {
  std::vector<Eigen::Vector3d> places;
  const Rigid3d world_from_cam = Inverse(view.cam_from_world);
  const Eigen::Vector2d extent = view.region.max_px - view.region.min_px;
  for (int row = 0; row < kGridRows; ++row) {
    for (int col = 0; col < kGridCols; ++col) {
      const Eigen::Vector2d pixel =
          view.region.min_px +
          extent.cwiseProduct(Eigen::Vector2d((col + 0.5) / kGridCols, (row + 0.5) / kGridRows));
      if (!view.region.Contains(pixel)) continue;
      const Eigen::Vector3d ray = view.camera.RayFromPixel(pixel);
      for (const double depth : depths) places.push_back(world_from_cam * (depth * ray));
    }
  }
  return places;
}

double Extent(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  std::vector<double> distances;
  for (const auto& point : points) distances.push_back((point - mean).norm());
  return 2 * Median(std::move(distances));
}

}  // namespace limn
