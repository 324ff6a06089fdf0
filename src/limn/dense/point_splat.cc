// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/point_splat.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn {
namespace {

constexpr double kMinCellPx = 1;
constexpr double kMaxCellPx = 16;

// A point in a view.
struct Seen {
  Eigen::Vector2d pixel;
  double depth;
};

std::optional<Seen> See(const View& view, const DensePoint& point) {
  const Eigen::Vector3d in_camera = view.cam_from_world * point.position;
  if (!(in_camera.z() > 0)) return std::nullopt;
  if (point.normal.dot(view.CenterInWorld() - point.position) < 0) return std::nullopt;
  const auto pixel = view.Project(point.position);
  if (!pixel) return std::nullopt;
  return Seen{*pixel, in_camera.z()};
}

template <typename Visit>
void ForEachSight(const DensePointStream& points, const std::vector<View>& views, size_t begin,
                  size_t end, const Visit& visit) {
  points([&](const DensePoint& point) {
    const auto look = [&](size_t v) {
      if (const auto seen = See(views[v], point)) visit(v - begin, point, *seen);
    };
    if (!point.views_known) {
      for (size_t v = begin; v < end; ++v) look(v);
      return;
    }
    for (const ViewId view : point.views) {
      const auto v = static_cast<size_t>(view);
      if (v >= begin && v < end) look(v);
    }
  });
}

// Without depths.
DepthImage Grid(const View& view, size_t num_seen) {
  DepthImage image;
  if (num_seen == 0) return image;
  const Eigen::Vector2d extent = view.region.max_px - view.region.min_px;
  const double area = extent.x() * extent.y();
  const double cell =
      std::clamp(std::sqrt(area / static_cast<double>(num_seen)), kMinCellPx, kMaxCellPx);
  image.width = static_cast<int>(std::ceil(extent.x() / cell)) + 1;
  image.height = static_cast<int>(std::ceil(extent.y() / cell)) + 1;
  image.cell_px = {cell, cell};
  image.origin_px = view.region.min_px;
  return image;
}

}  // namespace

size_t NumSplatCells(const View& view, size_t num_seen) {
  const DepthImage grid = Grid(view, num_seen);
  return static_cast<size_t>(grid.width) * grid.height;
}

std::vector<size_t> CountSeenPoints(const DensePointStream& points,
                                    const std::vector<View>& views) {
  std::vector<size_t> num_seen(views.size(), 0);
  ForEachSight(points, views, 0, views.size(),
               [&](size_t v, const DensePoint&, const Seen&) { ++num_seen[v]; });
  return num_seen;
}

std::vector<DepthImage> SplatPoints(const DensePointStream& points, const std::vector<View>& views,
                                    const std::vector<size_t>& num_seen, size_t begin, size_t end) {
  std::vector<DepthImage> images;
  for (size_t v = begin; v < end; ++v) {
    DepthImage& image = images.emplace_back(Grid(views[v], num_seen[v]));
    image.depth.assign(NumSplatCells(views[v], num_seen[v]), 0);
    image.normal_in_world.assign(image.depth.size(), Eigen::Vector3f::Zero());
  }
  ForEachSight(points, views, begin, end, [&](size_t v, const DensePoint& point, const Seen& seen) {
    DepthImage& image = images[v];
    const Eigen::Vector2i cell = image.CellAt(seen.pixel);
    if (!image.Contains(cell.x(), cell.y())) return;
    const size_t at = static_cast<size_t>(cell.y()) * image.width + cell.x();
    const auto depth = static_cast<float>(seen.depth);
    if (image.depth[at] > 0 && image.depth[at] <= depth) return;
    image.depth[at] = depth;
    image.normal_in_world[at] = point.normal.cast<float>();
  });
  return images;
}

}  // namespace limn
