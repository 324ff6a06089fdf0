// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/fragment_rays.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

FragmentRays UprightLine() {
  const View view = testing::LookAt({5, 0, 1}, {0, 0, 0});
  const ImageCurves curves =
      testing::ProjectCurves(view, {testing::Segment({0, 0, -0.7}, {0, 0, 0.7})});
  return MakeFragmentRays(view, curves, 0);
}

TEST(FragmentRaysTest, SpacedVerticesKeepTheirDistance) {
  const FragmentRays rays = UprightLine();
  const std::vector<int> vertices = SpacedVertices(rays, 5);
  EXPECT_EQ(vertices.front(), 0);
  EXPECT_EQ(vertices.back(), static_cast<int>(rays.size()) - 1);
  for (size_t i = 1; i + 1 < vertices.size(); ++i) {
    EXPECT_GE(rays.arc_px[vertices[i]] - rays.arc_px[vertices[i - 1]], 5);
  }
  const FragmentRays subset = Subset(rays, vertices);
  ASSERT_EQ(subset.size(), vertices.size());
  EXPECT_EQ(subset.arc_px[2], rays.arc_px[vertices[2]]);
}

TEST(FragmentRaysTest, NormalsAreAcrossRayAndTangent) {
  const FragmentRays rays = UprightLine();
  ASSERT_GT(rays.size(), 50u);
  for (size_t i = 1; i < rays.size(); ++i) {
    EXPECT_NEAR(rays.normals[i].norm(), 1, 1e-12);
    EXPECT_NEAR(rays.normals[i].dot(rays.rays[i]), 0, 1e-12);
    // The line is in one plane with the center.
    EXPECT_NEAR(rays.normals[i].dot(rays.rays[i - 1]), 0, 1e-6);
  }
}

}  // namespace
}  // namespace limn
