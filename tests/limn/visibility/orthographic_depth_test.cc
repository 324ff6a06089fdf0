// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/orthographic_depth.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

// Seen from above, y up: right is x, down is -y, forward is -z.
OrthographicFrame FromAbove() {
  OrthographicFrame frame;
  frame.axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  frame.min = {-2, -2};
  frame.max = {2, 2};
  frame.cell = 0.1;
  return frame;
}

// A square of 2 x 2 around the origin on z = 5 + slope x.
TriangleMesh Square(double slope) {
  const auto corner = [&](double x, double y) { return Eigen::Vector3d(x, y, 5 + slope * x); };
  return MakeTriangleMesh({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
                          {{0, 1, 2, 3}});
}

TEST(RenderOrthographicDepth, HasTheSurfaceWhereItIs) {
  for (const double slope : {0.0, 0.5}) {
    const OrthographicDepth depth = RenderOrthographicDepth(Square(slope), FromAbove());
    int num_covered = 0;
    for (int row = 0; row < depth.image.height; ++row) {
      for (int column = 0; column < depth.image.width; ++column) {
        const Eigen::Vector2d at = depth.image.PixelOf(column, row);
        const float found = depth.image.At(column, row);
        const bool inside = at.cwiseAbs().maxCoeff() < 1 - 1e-6;
        if (at.cwiseAbs().maxCoeff() > 1 + 1e-6) {
          EXPECT_EQ(found, 0);
        }
        if (!inside) continue;
        ++num_covered;
        EXPECT_NEAR(found + depth.front, -(5 + slope * at.x()), 1e-5);
      }
    }
    EXPECT_EQ(num_covered, 19 * 19);
  }
}

TEST(RenderOrthographicDepth, HidesWhatIsBehindAndNothingElse) {
  const OrthographicDepth depth = RenderOrthographicDepth(Square(0), FromAbove());
  EXPECT_TRUE(IsBehind(depth, {0, 0, 4}, 0.5));
  EXPECT_FALSE(IsBehind(depth, {0, 0, 4}, 1.5));
  EXPECT_FALSE(IsBehind(depth, {0, 0, 5}, 1e-4));
  EXPECT_FALSE(IsBehind(depth, {0, 0, 6}, 0));
  EXPECT_FALSE(IsBehind(depth, {1.5, 0, 4}, 0.1));  // beside the square
  EXPECT_FALSE(IsBehind(depth, {1e12, 0, 4}, 0.1));
}

TEST(SplatOrthographicDepth, PointsAreDiscs) {
  const OrthographicDepth depth =
      SplatOrthographicDepth({{0.5, 0.5, 5}, {0.5, 0.5, 3}, {1e12, 0, 7}}, FromAbove(), 0.3);
  EXPECT_TRUE(IsBehind(depth, {0.5, 0.5, 4}, 0.5));
  EXPECT_TRUE(IsBehind(depth, {0.65, 0.5, 4}, 0.5));
  EXPECT_FALSE(IsBehind(depth, {1.0, 0.5, 4}, 0.5));
  EXPECT_FALSE(IsBehind(depth, {0.5, -0.5, 4}, 0.5));
}

TEST(RenderOrthographicDepth, OfNothingIsEmpty) {
  const OrthographicDepth depth = RenderOrthographicDepth({}, FromAbove());
  EXPECT_FALSE(IsBehind(depth, {0, 0, -100}, 0));
}

}  // namespace
}  // namespace limn
