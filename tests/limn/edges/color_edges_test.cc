// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limn/edges/edge_detection.h"
#include "limn/edges/lab_channels.h"
#include "limn/util/angles.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;
using testing::AddNoise;
using testing::ConstantImage;
using testing::Disc;
using testing::HalfPlane;
using testing::Paint;
using testing::Quantize;

const std::vector<float> kRed = {160, 100, 100};
// As bright as kRed: 0.299 * 60 = 0.587 * 30.56.
const std::vector<float> kGreen = {100, 130.56f, 100};
// As green as each other.
const std::vector<float> kOrange = {125, 100, 80};
const std::vector<float> kBlue = {80, 100, 125};

EdgeDetectionOptions In(EdgeChannel channel) {
  EdgeDetectionOptions options;
  options.channel = channel;
  options.find_isoluminant = false;
  return options;
}

Image TwoColors(const std::vector<float>& outside, const std::vector<float>& inside,
                const testing::Shape& shape, int size) {
  Image image = ConstantImage(size, size, outside);
  Paint(shape, inside, &image);
  return image;
}

// Undirected angle between the normals, degrees.
double AngleDeg(const Edgel& edgel, const Vector2d& normal) {
  return Degrees(std::acos(std::min(1.0, std::abs(edgel.Normal().dot(normal)))));
}

TEST(ColorEdges, FindsWhatOneChannelMisses) {
  struct Case {
    EdgeChannel misses;
    std::vector<float> outside, inside;
  };
  for (const Case& c :
       {Case{EdgeChannel::kLuminance, kRed, kGreen}, Case{EdgeChannel::kGreen, kOrange, kBlue}}) {
    for (int degrees = 0; degrees < 180; degrees += 15) {
      const Vector2d normal(std::cos(degrees * kDeg), std::sin(degrees * kDeg));
      const Vector2d point(32.3, 31.6);
      const Image image = TwoColors(c.outside, c.inside, HalfPlane(point, normal), 64);
      EXPECT_TRUE(DetectEdges(image, In(c.misses)).edgels.empty());
      const EdgeMap map = DetectEdges(image, In(EdgeChannel::kColor));
      EXPECT_GE(map.edgels.size(), 44u) << static_cast<int>(c.misses) << ' ' << degrees;
      const double sense = map.edgels.front().Normal().dot(normal);
      for (const Edgel& edgel : map.edgels) {
        // Lab is not linear: a pixel on the edge is not quite between the two colors.
        EXPECT_NEAR((edgel.position_px - point).dot(normal), 0, 0.08);
        EXPECT_LT(AngleDeg(edgel, normal), 2);
        EXPECT_GT(edgel.Normal().dot(normal) * sense, 0);  // one sense along the edge
      }
    }
  }
}

TEST(ColorEdges, GraysAreAsInGreen) {
  // One channel, or three equal ones.
  for (const size_t channels : {1u, 3u}) {
    Image image = TwoColors(std::vector<float>(channels, 90), std::vector<float>(channels, 140),
                            Disc({40.2, 39.7}, 24), 80);
    const EdgeMap green = DetectEdges(image, In(EdgeChannel::kGreen));
    const EdgeMap color = DetectEdges(image, In(EdgeChannel::kColor));
    ASSERT_GT(green.edgels.size(), 140u);
    EXPECT_NEAR(static_cast<double>(color.edgels.size()), static_cast<double>(green.edgels.size()),
                2);
    for (const Edgel& edgel : color.edgels) {
      const auto distance = [&](const Edgel& other) {
        return (other.position_px - edgel.position_px).norm();
      };
      const Edgel& nearest = *std::min_element(
          green.edgels.begin(), green.edgels.end(),
          [&](const Edgel& a, const Edgel& b) { return distance(a) < distance(b); });
      EXPECT_LT(std::abs((nearest.position_px - edgel.position_px).dot(nearest.Normal())), 0.05);
      EXPECT_GT(nearest.Normal().dot(edgel.Normal()), 0.999);
      EXPECT_NEAR(edgel.strength / nearest.strength, 1, 0.1);  // thresholds mean the same
    }
  }
}

TEST(ColorEdges, CurvedEdges) {
  for (const double radius : {8.0, 12.0, 20.0, 50.0}) {
    const int size = static_cast<int>(2 * radius) + 40;
    const Vector2d center(size / 2 + 0.3, size / 2 - 0.4);
    const Image image = TwoColors(kRed, kGreen, Disc(center, radius), size);
    EdgeDetectionOptions options = In(EdgeChannel::kColor);
    options.fine_sigma_px = 0;
    double position = 0;
    double angle = 0;
    const std::vector<Edgel> edgels = DetectEdges(image, options).edgels;
    ASSERT_GT(static_cast<double>(edgels.size()), 2 * std::numbers::pi * radius * 0.9);
    for (const Edgel& edgel : edgels) {
      const Vector2d ray = edgel.position_px - center;
      position += std::pow(ray.norm() - radius, 2);
      angle += std::pow(AngleDeg(edgel, ray.normalized()), 2);
    }
    EXPECT_LT(std::sqrt(position / static_cast<double>(edgels.size())), 0.03) << radius;
    EXPECT_LT(std::sqrt(angle / static_cast<double>(edgels.size())), 0.5) << radius;
  }
}

TEST(ColorEdges, FalseEdgelsInNoise) {
  double density[2] = {0, 0};
  for (unsigned seed = 0; seed < 4; ++seed) {
    Image image = ConstantImage(256, 256, {128, 128, 128});
    AddNoise(5, seed, &image);
    Quantize(&image);
    for (const int color : {0, 1}) {
      const EdgeMap map = DetectEdges(image, In(color ? EdgeChannel::kColor : EdgeChannel::kGreen));
      density[color] += 1000 * static_cast<double>(map.edgels.size()) / (4 * 240 * 240);
    }
  }
  std::cout << "noise 5: " << density[1] << " false edgels per 1,000 px^2, in green " << density[0]
            << '\n';
  EXPECT_LT(density[1], 1.3 * density[0]);
  EXPECT_GT(density[1], 0.7 * density[0]);
}

TEST(LabChannels, KnownColors) {
  Image image = ConstantImage(1, 1, {255, 0, 0});
  const auto lab = [&](const std::vector<float>& color) -> Eigen::Vector3d {
    image.data = color;
    const auto channels = LabChannels(image);
    return Eigen::Vector3d(channels[0][0], channels[1][0], channels[2][0]) / 2.55;
  };
  EXPECT_LT((lab({255, 0, 0}) - Eigen::Vector3d(53.24, 80.09, 67.20)).norm(), 0.05);
  EXPECT_LT((lab({0, 255, 0}) - Eigen::Vector3d(87.73, -86.18, 83.18)).norm(), 0.05);
  EXPECT_LT((lab({0, 0, 255}) - Eigen::Vector3d(32.30, 79.19, -107.86)).norm(), 0.05);
  EXPECT_LT((lab({255, 255, 255}) - Eigen::Vector3d(100, 0, 0)).norm(), 0.05);
  EXPECT_LT((lab({0, 0, 0}) - Eigen::Vector3d(0, 0, 0)).norm(), 0.05);
  EXPECT_LT((lab({119, 119, 119}) - Eigen::Vector3d(50.03, 0, 0)).norm(), 0.05);
}

}  // namespace
}  // namespace limn
