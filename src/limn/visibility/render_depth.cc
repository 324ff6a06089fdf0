// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/render_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "limn/visibility/raster.h"

namespace limn {
namespace {

// Of the largest depth of the mesh; what is nearer to the camera's plane is cut off.
constexpr double kNearShare = 1e-8;

double LargestDepth(const std::vector<Eigen::Vector3d>& points_in_cam) {
  double largest = 0;
  for (const Eigen::Vector3d& point : points_in_cam) largest = std::max(largest, point.z());
  return largest;
}

// Where the side from `inner` to `outer` passes the near plane. Always asked in this direction, so
// that two triangles with a common side get the same point.
Eigen::Vector3d AtNearPlane(const Eigen::Vector3d& inner, const Eigen::Vector3d& outer,
                            double near) {
  const double t = (inner.z() - near) / (inner.z() - outer.z());
  Eigen::Vector3d point = inner + t * (outer - inner);
  point.z() = near;
  return point;
}

// The part of a triangle beyond the near plane: up to four corners.
std::vector<Eigen::Vector3d> ClipToNear(const std::array<Eigen::Vector3d, 3>& triangle,
                                        double near) {
  std::vector<Eigen::Vector3d> clipped;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& a = triangle[k];
    const Eigen::Vector3d& b = triangle[(k + 1) % 3];
    const bool a_in = a.z() >= near;
    const bool b_in = b.z() >= near;
    if (a_in) clipped.push_back(a);
    if (a_in != b_in) clipped.push_back(a_in ? AtNearPlane(a, b, near) : AtNearPlane(b, a, near));
  }
  return clipped;
}

// Depth on the plane of a triangle along the ray through a pixel, kept within the triangle's own
// depths: planes seen edge on have none.
class DepthOnPlane {
 public:
  DepthOnPlane(const std::array<Eigen::Vector3d, 3>& triangle,
               const std::vector<Eigen::Vector3d>& clipped, const PinholeCamera& camera)
      : camera_(camera),
        normal_((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0])),
        offset_(normal_.dot(triangle[0])) {
    for (const Eigen::Vector3d& corner : clipped) {
      nearest_ = std::min(nearest_, corner.z());
      farthest_ = std::max(farthest_, corner.z());
    }
  }

  double At(const Eigen::Vector2d& virtual_px) const {
    const double slope = normal_.dot(camera_.RayFromPixel(virtual_px));
    if (slope == 0) return nearest_;
    return std::clamp(offset_ / slope, nearest_, farthest_);
  }

 private:
  const PinholeCamera& camera_;
  Eigen::Vector3d normal_;
  double offset_;
  double nearest_ = std::numeric_limits<double>::infinity();
  double farthest_ = 0;
};

}  // namespace

DepthImage RenderDepth(const TriangleMesh& mesh, const View& view, double scale) {
  DepthImage image = MakeDepthImage(view, scale);
  std::vector<Eigen::Vector3d> points;
  points.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    points.push_back(view.cam_from_world * vertex);
  const double near = kNearShare * LargestDepth(points);
  if (!(near > 0)) return image;
  RasterWork work(image, mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Eigen::Vector3d, 3> triangle = {points[a], points[b], points[c]};
    const std::vector<Eigen::Vector3d> clipped = ClipToNear(triangle, near);
    if (clipped.size() < 3) continue;
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector3d& corner : clipped) {
      corners.push_back(image.FromVirtual(view.camera.Project(corner)));
    }
    const DepthOnPlane plane(triangle, clipped, view.camera);
    work.Add(FillPolygon(
        corners, [&](const Eigen::Vector2d& pixel) { return plane.At(pixel); }, &image));
  }
  return image;
}

}  // namespace limn
