// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/ridge_detection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;

ProbabilityMap MapOf(const Image& image) {
  ProbabilityMap map{image.width, image.height, image.data};
  for (float& value : map.values) value /= 255;
  return map;
}

Image Strokes(const std::vector<Vector2d>& corners, double width) {
  Image image = testing::ConstantImage(160, 120, {0});
  for (size_t i = 1; i < corners.size(); ++i) {
    testing::Paint(testing::Stroke(corners[i - 1], corners[i], width), {200}, &image);
  }
  return image;
}

// As a learned detector would draw it: Gaussian across, of standard deviation `sigma_px`.
ProbabilityMap SoftLine(const Vector2d& from, const Vector2d& to, double sigma_px) {
  ProbabilityMap map{160, 120, std::vector<float>(160 * 120)};
  const Vector2d along = (to - from).normalized();
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vector2d offset = Vector2d(x, y) - from;
      const double reach = std::clamp(offset.dot(along), 0.0, (to - from).norm());
      const double squared = (offset - reach * along).squaredNorm();
      map.values[y * 160 + x] =
          static_cast<float>(0.8 * std::exp(-squared / (2 * sigma_px * sigma_px)));
    }
  }
  return map;
}

// Largest distances of the edgels from a line, px and degrees, away from its ends.
void ExpectOnLine(const EdgeMap& map, const Vector2d& from, const Vector2d& to, double max_px,
                  double max_deg, int min_count) {
  const Vector2d along = (to - from).normalized();
  int count = 0;
  for (const Edgel& edgel : map.edgels) {
    const Vector2d offset = edgel.position_px - from;
    const double reach = offset.dot(along);
    const double across = offset.x() * along.y() - offset.y() * along.x();
    if (reach < 6 || reach > (to - from).norm() - 6 || std::abs(across) > 5) continue;
    ++count;
    EXPECT_LT(std::abs(across), max_px) << edgel.position_px.transpose();
    const double cosine = std::min(1.0, std::abs(edgel.Tangent().dot(along)));
    EXPECT_LT(Degrees(std::acos(cosine)), max_deg) << edgel.position_px.transpose();
  }
  EXPECT_GE(count, min_count);
}

TEST(RidgeDetection, SoftLinesAreFoundToATenthOfAPixel) {
  for (const double sigma_px : {0.7, 1.5, 3.0}) {
    for (const Vector2d& to : {Vector2d(140, 31.3), Vector2d(120, 100), Vector2d(25.4, 110)}) {
      const Vector2d from(20.3, 20.7);
      const EdgeMap map = DetectRidges(SoftLine(from, to, sigma_px), {});
      ExpectOnLine(map, from, to, 0.1, 3, static_cast<int>((to - from).norm() * 0.7));
      for (const Edgel& edgel : map.edgels) EXPECT_LE(edgel.strength, 0.81f);
    }
  }
}

// A blurred polyline, by area: within 0.1 px and 3 degrees away from its corners.
TEST(RidgeDetection, RenderedPolyline) {
  const std::vector<Vector2d> corners = {{20, 20}, {90, 35.5}, {130.2, 95}};
  const EdgeMap map = DetectRidges(MapOf(Strokes(corners, 2)), {});
  ExpectOnLine(map, corners[0], corners[1], 0.1, 3, 40);
  ExpectOnLine(map, corners[1], corners[2], 0.1, 3, 40);
}

// Lines of whole pixels, as Canny's: the rounding of half a pixel is smoothed.
TEST(RidgeDetection, BinaryLines) {
  const Vector2d from(20, 30), to(140, 70);
  ProbabilityMap map{160, 120, std::vector<float>(160 * 120)};
  for (int x = 20; x <= 140; ++x) {
    map.values[std::lround(30 + (x - 20) / 3.0) * 160 + x] = 1;
  }
  ExpectOnLine(DetectRidges(map, {.sigma_px = 1.5}), from, to, 0.2, 8, 90);
  // Half of the rounding is left, and linking fits the directions.
  ExpectOnLine(DetectRidges(map, {}), from, to, 0.25, 20, 90);
}

TEST(RidgeDetection, WideLinesHaveOneRidgeAndAreasNone) {
  const std::vector<Vector2d> corners = {{20, 20}, {140, 50}};
  ExpectOnLine(DetectRidges(MapOf(Strokes(corners, 5)), {}), corners[0], corners[1], 0.15, 3, 80);
  Image area = testing::ConstantImage(160, 120, {0});
  testing::Paint(testing::Disc({80, 60}, 30), {255}, &area);
  EXPECT_TRUE(DetectRidges(MapOf(area), {}).edgels.empty());
  EXPECT_TRUE(DetectRidges(MapOf(testing::ConstantImage(160, 120, {90})), {}).edgels.empty());
}

TEST(RidgeDetection, IsolatedPixelsAreNoEdges) {
  ProbabilityMap map{160, 120, std::vector<float>(160 * 120)};
  map.values[60 * 160 + 80] = 1;
  EXPECT_TRUE(DetectRidges(map, {}).edgels.empty());
}

TEST(RidgeDetection, TheThresholdIsAProbability) {
  const ProbabilityMap map = SoftLine({20, 20}, {140, 50}, 2);
  EXPECT_FALSE(DetectRidges(map, {.min_probability = 0.7}).edgels.empty());
  EXPECT_TRUE(DetectRidges(map, {.min_probability = 0.85}).edgels.empty());
}

TEST(RidgeDetection, BadInputIsRefused) {
  EXPECT_THROW(DetectRidges({4, 4, std::vector<float>(15)}, {}), InputError);
  EXPECT_THROW(DetectRidges({4, 4, std::vector<float>(16)}, {.min_probability = 0}), OptionError);
  EXPECT_TRUE(DetectRidges({1, 1, {1}}, {}).edgels.empty());
}

}  // namespace
}  // namespace limn
