// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include "limn/geometry/weld.h"

namespace limn {
namespace {

TEST(WeldPoints, EqualPositionsHaveOneRepresentative) {
  EXPECT_EQ(WeldPoints({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {1, 2, 3 + 1e-15}, {0, 0, 0}}),
            (std::vector<int>{0, 1, 0, 3, 1}));
  EXPECT_TRUE(WeldPoints({}).empty());
}

TEST(MakeTriangleMesh, WeldsVerticesOfFacesThatShareThem) {
  const TriangleMesh mesh = MakeTriangleMesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.polygons, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.num_degenerate + mesh.num_copies, 0);
}

TEST(MakeTriangleMesh, FacesWithoutAreaAndCopiesAreLeftOut) {
  const TriangleMesh mesh =
      MakeTriangleMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 0, 0}},
                       {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {1, 4, 2}, {0, 4, 1, 2, 2}});
  EXPECT_EQ(mesh.polygons, (std::vector<std::vector<int>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.num_degenerate, 2);  // on a line; two corners at one place
  EXPECT_EQ(mesh.num_copies, 2);      // turned round; with repeated corners
}

}  // namespace
}  // namespace limn
