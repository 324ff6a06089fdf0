#include "limn/geometry/triangulation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector3d;

TEST(DepthOnRay, RaysThatMeetGiveTheirPoint) {
  const Vector3d point(0.3, -0.2, 5);
  const Vector3d ray_a = point / point.z();
  const Vector3d origin_b(1, 0.1, 0.2);
  const auto depth = DepthOnRay(ray_a, origin_b, point - origin_b);
  ASSERT_TRUE(depth);
  EXPECT_NEAR(*depth, 5, 1e-12);
}

TEST(DepthOnRay, SkewRaysGiveTheNearestPointOnTheFirst) {
  // Ray b crosses above ray a at depth 3.
  const auto depth = DepthOnRay({0, 0, 1}, {1, 0.25, 2}, {-1, 0, 1});
  ASSERT_TRUE(depth);
  EXPECT_NEAR(*depth, 3, 1e-12);
}

TEST(DepthOnRay, ParallelRaysAndPointsBehindGiveNothing) {
  EXPECT_FALSE(DepthOnRay({0, 0, 1}, {1, 0, 0}, {0, 0, 2}));
  EXPECT_FALSE(DepthOnRay({0, 0, 1}, {1, 0, 0}, {-1, 0, -1}));  // behind camera a
  EXPECT_FALSE(DepthOnRay({0, 0, 1}, {1, 0, 0}, {1, 0, -1}));   // behind camera b
}

TEST(TangentFromPlanes, RecoversTheLineOfBothPlanes) {
  const Vector3d tangent = Vector3d(1, 2, -0.5).normalized();
  const Vector3d point(0.1, 0.2, 4);
  const Vector3d center_b(1, 0, 0);
  const Vector3d normal_a = point.cross(tangent);
  const Vector3d normal_b = (point - center_b).cross(tangent);
  const auto found = TangentFromPlanes(normal_a, normal_b);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->norm(), 1, 1e-12);
  EXPECT_NEAR(std::abs(found->dot(tangent)), 1, 1e-12);
}

TEST(TangentFromPlanes, TangentInTheEpipolarPlaneGivesNothing) {
  EXPECT_FALSE(TangentFromPlanes({0, 1, 0}, {0, -2, 0}));
}

}  // namespace
}  // namespace limn
