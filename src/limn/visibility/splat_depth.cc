#include "limn/visibility/splat_depth.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

void PutDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image) {
  const auto first = [](double at) { return static_cast<int>(std::max(0.0, std::ceil(at))); };
  const auto last = [](double at, int count) {
    return static_cast<int>(std::min(count - 1.0, std::floor(at)));
  };
  for (int row = first(center.y() - radius); row <= last(center.y() + radius, image->height);
       ++row) {
    for (int column = first(center.x() - radius); column <= last(center.x() + radius, image->width);
         ++column) {
      if ((Eigen::Vector2d(column, row) - center).squaredNorm() > radius * radius) continue;
      float& depth = image->depth[static_cast<size_t>(row) * image->width + column];
      if (depth == 0 || z < depth) depth = z;
    }
  }
}

}  // namespace

DepthImage SplatDepth(const std::vector<Eigen::Vector3d>& points_in_world, const View& view,
                      double scale, double radius_px) {
  DepthImage image = MakeDepthImage(view, scale);
  const double radius = radius_px * scale;
  for (const Eigen::Vector3d& point : points_in_world) {
    const Eigen::Vector3d point_in_cam = view.cam_from_world * point;
    if (!(point_in_cam.z() > 0)) continue;
    const Eigen::Vector2d center = image.FromVirtual(view.camera.Project(point_in_cam));
    if (!(center.x() >= -radius && center.x() <= image.width - 1 + radius &&
          center.y() >= -radius && center.y() <= image.height - 1 + radius)) {
      continue;
    }
    PutDisc(center, radius, static_cast<float>(point_in_cam.z()), &image);
  }
  return image;
}

}  // namespace limn
