// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/orthographic_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "limn/visibility/raster.h"

namespace limn {
namespace {

std::vector<Eigen::Vector3d> InFrame(const std::vector<Eigen::Vector3d>& points,
                                     const Eigen::Matrix3d& axes) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points) result.push_back(axes * point);
  return result;
}

// Nothing in it yet; `front` such that all points have a positive depth.
OrthographicDepth EmptyDepth(const std::vector<Eigen::Vector3d>& points_in_frame,
                             const OrthographicFrame& frame) {
  OrthographicDepth depth;
  depth.axes = frame.axes;
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (const Eigen::Vector3d& point : points_in_frame) {
    nearest = std::min(nearest, point.z());
    farthest = std::max(farthest, point.z());
  }
  if (!points_in_frame.empty()) {
    depth.front = nearest - std::max(farthest - nearest, frame.cell);
  }
  DepthImage& image = depth.image;
  image.origin_px = frame.min;
  image.cell_px = Eigen::Vector2d::Constant(frame.cell);
  const Eigen::Vector2d cells = (frame.max - frame.min) / frame.cell;
  image.width = static_cast<int>(std::ceil(cells.x())) + 1;
  image.height = static_cast<int>(std::ceil(cells.y())) + 1;
  image.depth.assign(static_cast<size_t>(image.width) * image.height, 0);
  return depth;
}

size_t FillTriangle(const std::array<Eigen::Vector3d, 3>& triangle, OrthographicDepth* depth) {
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const auto [nearest, farthest] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
  const auto depth_at = [&, near = nearest, far = farthest](const Eigen::Vector2d& at) {
    if (normal.z() == 0) return near - depth->front;  // seen edge on
    const Eigen::Vector2d away = at - triangle[0].head<2>();
    const double z = triangle[0].z() - normal.head<2>().dot(away) / normal.z();
    return std::clamp(z, near, far) - depth->front;
  };
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : triangle) {
    corners.push_back(depth->image.FromVirtual(corner.head<2>()));
  }
  return FillPolygon(corners, depth_at, &depth->image);
}

}  // namespace

OrthographicDepth RenderOrthographicDepth(const TriangleMesh& mesh,
                                          const OrthographicFrame& frame) {
  const std::vector<Eigen::Vector3d> points = InFrame(mesh.vertices, frame.axes);
  OrthographicDepth depth = EmptyDepth(points, frame);
  RasterWork work(depth.image, mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    work.Add(FillTriangle({points[a], points[b], points[c]}, &depth));
  }
  return depth;
}

OrthographicDepth SplatOrthographicDepth(const std::vector<Eigen::Vector3d>& points_in_world,
                                         const OrthographicFrame& frame, double radius) {
  const std::vector<Eigen::Vector3d> points = InFrame(points_in_world, frame.axes);
  OrthographicDepth depth = EmptyDepth(points, frame);
  RasterWork work(depth.image, points.size());
  for (const Eigen::Vector3d& point : points) {
    work.Add(FillDisc(depth.image.FromVirtual(point.head<2>()), radius / frame.cell,
                      static_cast<float>(point.z() - depth.front), &depth.image));
  }
  return depth;
}

bool IsBehind(const OrthographicDepth& depth, const Eigen::Vector3d& point_in_world,
              double tolerance) {
  const Eigen::Vector3d point = depth.axes * point_in_world;
  const Eigen::Vector2i cell = depth.image.CellAt(point.head<2>());
  if (!depth.image.Contains(cell.x(), cell.y())) return false;
  return IsBehind(depth.image, point.head<2>(), point.z() - depth.front, tolerance);
}

}  // namespace limn
