// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/point_splat.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/dense/plate_scene.h"
#include "limn/dense/point_distance.h"

namespace limn {
namespace {

// The plate as points, 12 mm apart, seen by everybody.
DensePointStream PlatePoints(const Eigen::Vector3d& normal, std::vector<ViewId> views = {}) {
  return [=](const DensePointVisitor& visit) {
    DensePoint point;
    point.normal = normal;
    point.views = views;
    point.views_known = !views.empty();
    for (int x = -50; x <= 50; ++x) {
      for (int y = -50; y <= 50; ++y) {
        point.position = {0.012 * x, 0.012 * y, 0};
        visit(point);
      }
    }
  };
}

size_t NumKnown(const DepthImage& image) {
  return static_cast<size_t>(
      std::count_if(image.depth.begin(), image.depth.end(), [](float depth) { return depth > 0; }));
}

std::vector<DepthImage> Splat(const DensePointStream& points, size_t end) {
  const auto& views = testing::PlateViews();
  return SplatPoints(points, views, CountSeenPoints(points, views), 0, end);
}

TEST(PointSplat, DepthsAreThoseOfThePoints) {
  const auto& views = testing::PlateViews();
  const auto images = Splat(PlatePoints({0, 0, 1}), views.size());
  ASSERT_EQ(images.size(), views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    // About as many cells as points in the whole image.
    EXPECT_LT(images[v].width * images[v].height, 1.2 * 101 * 101);
    EXPECT_GT(NumKnown(images[v]), 300u);
    const Eigen::Vector3d place(0.012, -0.024, 0);
    const Eigen::Vector2i cell = images[v].CellAt(*views[v].Project(place));
    const double cell_size = images[v].cell_px.x() * testing::kPlatePx;
    EXPECT_NEAR(images[v].DepthOr0(cell.x(), cell.y()), (views[v].cam_from_world * place).z(),
                2 * cell_size);
    const auto normal = NormalAt(views[v], images[v], cell.x(), cell.y());
    ASSERT_TRUE(normal);
    EXPECT_GT(normal->z(), 0.99);
  }
}

TEST(PointSplat, BacksAndOtherViewsSeeNothing) {
  for (const DepthImage& image : Splat(PlatePoints({0, 0, -1}), 2)) {
    EXPECT_EQ(image.width, 0);
  }
  const auto images = Splat(PlatePoints({0, 0, 1}, {1}), 3);
  EXPECT_EQ(NumKnown(images[0]), 0u);
  EXPECT_GT(NumKnown(images[1]), 300u);
  EXPECT_EQ(NumKnown(images[2]), 0u);
}

TEST(PointDistance, CountsFootprints) {
  DrawingSamples samples;
  for (const double height : {0.0, 1.9 * testing::kPlatePx, 2.1 * testing::kPlatePx}) {
    samples.position.push_back({0.012, 0.012, height});
    samples.footprint.push_back(testing::kPlatePx);
  }
  EXPECT_EQ(FindSamplesNearPoints(samples, PlatePoints({0, 0, 1}), 2),
            (std::vector<uint8_t>{1, 1, 0}));
  EXPECT_TRUE(FindSamplesNearPoints({}, PlatePoints({0, 0, 1}), 2).empty());
}

}  // namespace
}  // namespace limn
