// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polygon_triangulation.h"

#include <chrono>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

// The flat polygon somewhere in space.
Polygon InSpace(const std::vector<Eigen::Vector2d>& flat) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  Polygon polygon;
  for (const Eigen::Vector2d& corner : flat) {
    polygon.push_back(turn * Eigen::Vector3d(corner.x(), corner.y(), 0) +
                      Eigen::Vector3d(3, -1, 2));
  }
  return polygon;
}

// The triangles have the polygon's orientation and, together, its area: so they do not overlap.
void ExpectCovered(const Polygon& polygon, size_t num_triangles) {
  const auto triangles = TriangulatePolygon(polygon);
  EXPECT_EQ(triangles.size(), num_triangles);
  const Eigen::Vector3d area = PolygonAreaVector(polygon);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d part = PolygonAreaVector(Polygon{polygon[a], polygon[b], polygon[c]});
    EXPECT_GT(part.dot(area), 0);
    sum += part.norm();
  }
  EXPECT_NEAR(sum, area.norm(), 1e-9 * area.norm());
}

TEST(TriangulatePolygon, TriangleSquareAndSlantedSquare) {
  ExpectCovered(InSpace({{0, 0}, {1, 0}, {0, 1}}), 1);
  ExpectCovered(InSpace({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 2);
  EXPECT_NEAR(PolygonAreaVector(InSpace({{0, 0}, {3, 0}, {3, 1}, {0, 1}})).norm(), 6, 1e-12);
}

TEST(TriangulatePolygon, ConcavePolygons) {
  ExpectCovered(InSpace({{-2, 0}, {-1, 0}, {-1, 2}, {1, 2}, {1, 0}, {2, 0}, {2, 3}, {-2, 3}}), 6);
  std::vector<Eigen::Vector2d> star;
  for (int i = 0; i < 14; ++i) {
    const double radius = i % 2 ? 0.3 : 1;
    star.emplace_back(radius * std::cos(M_PI * i / 7), radius * std::sin(M_PI * i / 7));
  }
  ExpectCovered(InSpace(star), 12);
  std::reverse(star.begin(), star.end());
  ExpectCovered(InSpace(star), 12);
}

TEST(TriangulatePolygon, ManyCornersAtRandomDistances) {
  std::mt19937 random(7);
  testing::UniformDistribution<double> radius(0.2, 1);
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * M_PI * i / 300;
    corners.push_back(radius(random) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  ExpectCovered(InSpace(corners), 298);
}

// Looking at all corners again after every ear took most of a minute.
TEST(TriangulatePolygon, LongSpiralTakesNoTime) {
  std::vector<Eigen::Vector2d> corners;
  const auto add = [&](int i, double width) {
    const double angle = 0.15 * i;
    corners.push_back((1 + 0.02 * i + width) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  for (int i = 5000; i > 0; --i) add(i, 0);
  for (int i = 1; i <= 5000; ++i) add(i, 0.1);
  const auto begin = std::chrono::steady_clock::now();
  ExpectCovered(InSpace(corners), 9998);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

// A square with a square hole, cut open along a line to the hole that is gone twice.
TEST(TriangulatePolygon, PolygonsMayTouchThemselves) {
  ExpectCovered(
      InSpace({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}), 8);
}

TEST(TriangulatePolygon, CornersOnStraightSidesCostNothing) {
  // In coordinate planes the corner at (1, 0) is exactly on its side.
  const Polygon square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  double sum = 0;
  for (const auto& [a, b, c] : TriangulatePolygon(square)) {
    sum += PolygonAreaVector(Polygon{square[a], square[b], square[c]}).z();
  }
  EXPECT_DOUBLE_EQ(sum, 8);
}

TEST(TriangulatePolygon, PolygonsThatCrossThemselvesAndTooFewCornersEnd) {
  EXPECT_LE(TriangulatePolygon(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_TRUE(TriangulatePolygon(Polygon{{0, 0, 0}, {1, 1, 0}}).empty());
}

}  // namespace
}  // namespace limn
