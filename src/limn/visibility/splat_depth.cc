// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/splat_depth.h"

#include "limn/visibility/raster.h"

namespace limn {

DepthImage SplatDepth(const std::vector<Eigen::Vector3d>& points_in_world, const View& view,
                      double scale, double radius_px) {
  DepthImage image = MakeDepthImage(view, scale);
  const double radius = radius_px * scale;
  RasterWork work(image, points_in_world.size());
  for (const Eigen::Vector3d& point : points_in_world) {
    const Eigen::Vector3d point_in_cam = view.cam_from_world * point;
    if (!(point_in_cam.z() > 0)) continue;
    const Eigen::Vector2d center = image.FromVirtual(view.camera.Project(point_in_cam));
    work.Add(FillDisc(center, radius, static_cast<float>(point_in_cam.z()), &image));
  }
  return image;
}

}  // namespace limn
