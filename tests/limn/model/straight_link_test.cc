// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/straight_link.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

DrawingLink LinkThrough(const std::vector<Eigen::Vector3d>& points) {
  DrawingLink link;
  link.points_in_world = points;
  return link;
}

TEST(StraightLink, IsWhatItsPrimitiveSays) {
  DrawingLink link = LinkThrough({{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0}});
  EXPECT_FALSE(LineOf(link));
  link.primitive = LinkPrimitive{LineSegment{{0, 0.1, 0}, {2, 0.1, 0}}};
  ASSERT_TRUE(LineOf(link));
  EXPECT_EQ(LineOf(link)->end, Eigen::Vector3d(2, 0.1, 0));
  link = LinkThrough({{0, 0, 0}, {1, 0, 0}});
  link.primitive = LinkPrimitive{CircularArc{}};
  EXPECT_FALSE(LineOf(link));
}

TEST(StraightLink, WithoutPrimitiveIsNearItsChord) {
  EXPECT_TRUE(LineOf(LinkThrough({{0, 0, 0}, {1, 0.019, 0}, {2, 0, 0}})));
  EXPECT_FALSE(LineOf(LinkThrough({{0, 0, 0}, {1, 0.021, 0}, {2, 0, 0}})));
  DrawingLink loop = LinkThrough({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
  loop.closed = true;
  EXPECT_FALSE(LineOf(loop));
}

}  // namespace
}  // namespace limn
