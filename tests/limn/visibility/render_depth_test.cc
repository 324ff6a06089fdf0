// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/render_depth.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::CubeCorners;
using testing::CubeMesh;
using testing::LookAt;

constexpr double kFloatError = 1e-6;

View Forward(int width = 64, int height = 48, double focal = 50) {
  return testing::ForwardView(width, height, focal);
}

TriangleMesh MeshOf(const std::vector<Eigen::Vector3d>& polygon) {
  std::vector<int> corners(polygon.size());
  for (size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<int>(i);
  return MakeTriangleMesh(polygon, {corners});
}

int NumCovered(const DepthImage& image) {
  int covered = 0;
  for (const float depth : image.depth) covered += depth > 0;
  return covered;
}

TEST(RenderDepth, PlaneGivesItsDepthAtEveryPixel) {
  // z = 2 + 0.5 x, far beyond the image on all sides.
  const TriangleMesh plane = MeshOf({{-3, -9, 0.5}, {9, -9, 6.5}, {9, 9, 6.5}, {-3, 9, 0.5}});
  const View view = Forward();
  for (const double scale : {0.5, 1.0, 2.0}) {
    const DepthImage image = RenderDepth(plane, view, scale);
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const Eigen::Vector2d pixel = image.origin_px + Eigen::Vector2d(column, row) / scale;
        const Eigen::Vector3d ray = view.camera.RayFromPixel(pixel);
        EXPECT_NEAR(image.At(column, row), 2 / (1 - 0.5 * ray.x()), 10 * kFloatError);
      }
    }
  }
}

TEST(RenderDepth, TheNearestSurfaceCounts) {
  const View view = LookAt({4, 0, 0}, {0, 0, 0});
  const DepthImage image = RenderDepth(CubeMesh({0, 0, 0}, 0.5), view, 1);
  const Eigen::Vector2d middle = image.FromVirtual({319.5, 239.5});
  EXPECT_NEAR(image.At(static_cast<int>(middle.x()), static_cast<int>(middle.y())), 3.5,
              kFloatError);
  EXPECT_EQ(image.At(0, 0), 0);
  // The near face: 600 px / 3.5.
  EXPECT_NEAR(NumCovered(image), std::pow(600 / 3.5, 2), 2 * 600 / 3.5);
}

// Pixel centers on common sides and corners, in particular the diagonals: no hole, and nothing
// beyond the border.
TEST(RenderDepth, TrianglesLeaveNoCracks) {
  std::mt19937 random(5);
  testing::UniformDistribution<double> jitter(-0.4, 0.4);
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;
  constexpr int kCells = 40;
  for (int row = 0; row <= kCells; ++row) {
    for (int column = 0; column <= kCells; ++column) {
      const bool inner = row > 0 && row < kCells && column > 0 && column < kCells;
      // Every other vertex at a pixel's center.
      const bool moved = inner && (row + column) % 2 == 1;
      vertices.emplace_back(column + (moved ? jitter(random) : 0) - 20 + 0.5,
                            row + (moved ? jitter(random) : 0) - 20 + 0.5, 50);
    }
  }
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int a = row * (kCells + 1) + column;
      faces.push_back({a, a + 1, a + kCells + 2});
      faces.push_back({a + kCells + 2, a + kCells + 1, a});
    }
  }
  // x / z * focal: pixels are the vertices' units.
  const DepthImage image = RenderDepth(MakeTriangleMesh(vertices, faces), Forward(), 1);
  EXPECT_EQ(NumCovered(image), (kCells + 1) * (kCells + 1));
}

TEST(RenderDepth, ConcavePolygonsKeepTheirOpening) {
  // A gate: legs at the sides, a beam above, y down.
  const TriangleMesh gate = MeshOf({{-2, -2, 5},
                                    {2, -2, 5},
                                    {2, 2, 5},
                                    {1, 2, 5},
                                    {1, -1, 5},
                                    {-1, -1, 5},
                                    {-1, 2, 5},
                                    {-2, 2, 5}});
  const DepthImage image = RenderDepth(gate, Forward(), 1);
  const auto depth_at = [&](double x, double y) {
    const Eigen::Vector2d pixel = Forward().camera.Project({x, y, 5});
    return image.At(static_cast<int>(std::lround(pixel.x())),
                    static_cast<int>(std::lround(pixel.y())));
  };
  EXPECT_EQ(depth_at(0, 0.5), 0);
  EXPECT_NEAR(depth_at(-1.5, 0.5), 5, kFloatError);
  EXPECT_NEAR(depth_at(1.5, 0.5), 5, kFloatError);
  EXPECT_NEAR(depth_at(0, -1.5), 5, kFloatError);
}

TEST(RenderDepth, GroundThatReachesBehindTheCameraIsClipped) {
  // One meter below the camera, from far behind it to far ahead; y is down.
  const TriangleMesh ground = MeshOf({{-90, 1, -80}, {90, 1, -80}, {90, 1, 80}, {-90, 1, 80}});
  const View view = Forward();
  const DepthImage image = RenderDepth(ground, view, 1);
  for (int row = 0; row < image.height; ++row) {
    const double down = view.camera.RayFromPixel({0, row}).y();
    for (int column = 0; column < image.width; ++column) {
      if (down > 0.0126) {
        EXPECT_NEAR(image.At(column, row), 1 / down, 1e-6 / down) << row;
      } else if (down < 0.0124) {
        EXPECT_EQ(image.At(column, row), 0) << row;
      }
    }
  }
}

TEST(RenderDepth, NothingInFrontOfTheCamera) {
  EXPECT_EQ(NumCovered(RenderDepth(CubeMesh({0, 0, -9}, 1), Forward(), 1)), 0);
  EXPECT_EQ(NumCovered(RenderDepth(TriangleMesh(), Forward(), 1)), 0);
}

TEST(IsVisible, CornersOfACubeAreSeenFromTheirSide) {
  const TriangleMesh cube = CubeMesh({0, 0, 0}, 0.5);
  for (const Eigen::Vector3d& eye :
       {Eigen::Vector3d(4, 0.3, 0.2), {3, 2.5, 2}, {-2, 3, -1.5}, {-1.2, -0.9, 3}}) {
    const View view = LookAt(eye, {0, 0, 0});
    const DepthImage depth = RenderDepth(cube, view, 2);
    for (const Eigen::Vector3d& corner : CubeCorners(0.5)) {
      // A corner is hidden if all three faces at it look away.
      bool seen = false;
      for (int axis = 0; axis < 3; ++axis) {
        seen = seen || (eye[axis] - corner[axis]) * corner[axis] > 0;
      }
      EXPECT_EQ(IsVisible(view, depth, corner, 2), seen)
          << eye.transpose() << ": " << corner.transpose();
    }
  }
}

TEST(IsVisible, ToleranceIsInFootprints) {
  const View view = LookAt({0, -6, 0}, {0, 0, 0});
  const TriangleMesh wall =
      MakeTriangleMesh({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}}, {{0, 1, 2, 3}});
  const DepthImage depth = RenderDepth(wall, view, 2);
  const double footprint = 6.0 / 600;
  EXPECT_TRUE(IsVisible(view, depth, {0.1, 1.9 * footprint, 0.2}, 2));
  EXPECT_FALSE(IsVisible(view, depth, {0.1, 2.1 * footprint, 0.2}, 2));
  EXPECT_TRUE(IsVisible(view, depth, {0.1, -1, 0.2}, 0));
  EXPECT_FALSE(IsVisible(view, depth, {0.1, -7, 0.2}, 2));  // behind the camera
  EXPECT_FALSE(IsVisible(view, depth, {8, -1, 0}, 2));      // outside the image
}

}  // namespace
}  // namespace limn
