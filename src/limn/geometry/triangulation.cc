#include "limn/geometry/triangulation.h"

#include <cmath>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Rays (or planes) closer to parallel than this, as a squared sine, define nothing.
constexpr double kMinSquaredSine = 1e-12;

}  // namespace

std::optional<double> DepthOnRay(const Eigen::Vector3d& ray_a, const Eigen::Vector3d& origin_b,
                                 const Eigen::Vector3d& ray_b) {
  const double aa = ray_a.squaredNorm();
  const double bb = ray_b.squaredNorm();
  const double ab = ray_a.dot(ray_b);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > kMinSquaredSine * aa * bb)) return std::nullopt;
  const double ao = ray_a.dot(origin_b);
  const double bo = ray_b.dot(origin_b);
  const double depth_a = (bb * ao - ab * bo) / determinant;
  const double depth_b = (ab * ao - aa * bo) / determinant;
  if (!(depth_a > 0 && depth_b > 0)) return std::nullopt;
  return depth_a;
}

std::optional<Eigen::Vector3d> TangentFromPlanes(const Eigen::Vector3d& normal_a,
                                                 const Eigen::Vector3d& normal_b) {
  const Eigen::Vector3d direction = normal_a.cross(normal_b);
  const double squared = direction.squaredNorm();
  if (!(squared > kMinSquaredSine * normal_a.squaredNorm() * normal_b.squaredNorm())) {
    return std::nullopt;
  }
  return direction / std::sqrt(squared);
}

}  // namespace limn
