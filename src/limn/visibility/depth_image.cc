#include "limn/visibility/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

// The farthest of the depth pixels around a position in depth pixels; infinite where there is
// nothing.
double FarthestAround(const DepthImage& image, const Eigen::Vector2d& at) {
  const auto clamped = [](double value, int count) {
    return static_cast<int>(std::clamp(value, 0.0, count - 1.0));
  };
  const int columns[] = {clamped(std::floor(at.x()), image.width),
                         clamped(std::ceil(at.x()), image.width)};
  const int rows[] = {clamped(std::floor(at.y()), image.height),
                      clamped(std::ceil(at.y()), image.height)};
  double farthest = 0;
  for (const int row : rows) {
    for (const int column : columns) {
      const double depth = image.At(column, row);
      if (!(depth > 0)) return std::numeric_limits<double>::infinity();
      farthest = std::max(farthest, depth);
    }
  }
  return farthest;
}

}  // namespace

DepthImage MakeDepthImage(const View& view, double scale) {
  const Eigen::Vector2d extent = view.region.max_px - view.region.min_px;
  DepthImage image;
  image.scale = scale;
  image.origin_px = view.region.min_px;
  image.width = std::max(0, static_cast<int>(std::ceil(extent.x() * scale))) + 1;
  image.height = std::max(0, static_cast<int>(std::ceil(extent.y() * scale))) + 1;
  image.depth.assign(static_cast<size_t>(image.width) * image.height, 0);
  return image;
}

bool IsVisible(const View& view, const DepthImage& depth, const Eigen::Vector3d& point_in_world,
               double tolerance_px) {
  const auto pixel = view.Project(point_in_world);
  if (!pixel) return false;
  const double z = (view.cam_from_world * point_in_world).z();
  const double tolerance = tolerance_px * z / view.camera.MeanFocal();
  return z <= FarthestAround(depth, depth.FromVirtual(*pixel)) + tolerance;
}

}  // namespace limn
