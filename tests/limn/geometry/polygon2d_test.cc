// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polygon2d.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/geometry/polygon_with_holes.h"

namespace limn {
namespace {

Polyline2d Box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Polyline2d Reversed(Polyline2d corners) { return {corners.rbegin(), corners.rend()}; }

// A frame with two windows.
Polygon2d Windows() {
  return {{Box(0, 0, 10, 6), Reversed(Box(1, 1, 4, 5)), Reversed(Box(6, 1, 9, 5))}};
}

TEST(Polygon2d, InsideDistanceAndArea) {
  const Polygon2d polygon = Windows();
  EXPECT_TRUE(polygon.Contains({5, 3}));
  EXPECT_TRUE(polygon.Contains({0.5, 0.5}));
  EXPECT_FALSE(polygon.Contains({2, 2}));
  EXPECT_FALSE(polygon.Contains({11, 3}));
  EXPECT_NEAR(polygon.DistanceToOutline({5, 3}), 1, 1e-12);
  EXPECT_NEAR(polygon.DistanceToOutline({12, 8}), std::sqrt(8), 1e-12);
  EXPECT_NEAR(polygon.Area(), 60 - 24, 1e-12);
  EXPECT_NEAR(Perimeter(polygon.outlines[0]), 32, 1e-12);
  EXPECT_NEAR(SignedArea(polygon.outlines[1]), -12, 1e-12);
}

TEST(Polygon2d, RaysEndAtTheFirstOutline) {
  const Polygon2d polygon = Windows();
  const OutlinePlace left = polygon.FirstCrossing({5, 3}, {-1, 0});
  EXPECT_EQ(left.loop, 1);
  EXPECT_NEAR(left.distance, 1, 1e-12);
  const OutlinePlace up = polygon.FirstCrossing({5, 3}, {0, 1});
  EXPECT_EQ(up.loop, 0);
  EXPECT_EQ(up.corner, 2);
  EXPECT_NEAR(up.t, 0.5, 1e-12);
  EXPECT_EQ(polygon.FirstCrossing({20, 3}, {1, 0}).loop, -1);
}

// Counterclockwise triangles of the right area in all, each inside: they cover it exactly.
void ExpectTriangulated(const Polygon2d& polygon) {
  Polyline2d corners;
  for (const Polyline2d& outline : polygon.outlines) {
    corners.insert(corners.end(), outline.begin(), outline.end());
  }
  double sum = 0;
  for (const auto& [a, b, c] : Triangulate(polygon)) {
    const double area = SignedArea(Polyline2d{corners[a], corners[b], corners[c]});
    EXPECT_GT(area, 0);
    EXPECT_TRUE(polygon.Contains((corners[a] + corners[b] + corners[c]) / 3));
    sum += area;
  }
  EXPECT_NEAR(sum, polygon.Area(), 1e-9);
}

TEST(Triangulate, PolygonsWithHoles) {
  ExpectTriangulated({{Box(0, 0, 1, 1)}});
  ExpectTriangulated(Windows());
  // Holes on top of each other, and one that only the one before sees.
  ExpectTriangulated({{Box(0, 0, 10, 10), Reversed(Box(4, 1, 6, 2)), Reversed(Box(4, 4, 6, 5)),
                       Reversed(Box(1, 0.5, 3, 9)), Reversed(Box(7, 0.5, 9, 9))}});
}

TEST(Triangulate, RoundHoleInAConcaveBorder) {
  Polyline2d round;
  for (int i = 0; i < 60; ++i) {
    round.emplace_back(1.5 + 0.4 * std::cos(-M_PI * i / 30), 0.5 + 0.4 * std::sin(-M_PI * i / 30));
  }
  ExpectTriangulated(
      {{{{0, 0}, {2, 0}, {2, 3}, {1.9, 3}, {1.8, 1}, {1, 1}, {1, 2}, {0, 2}}, round}});
}

}  // namespace
}  // namespace limn
