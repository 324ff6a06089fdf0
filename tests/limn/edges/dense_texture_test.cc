// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/dense_texture.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "limn/edges/edge_detection.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

constexpr int kTexturePx = 120;

class DenseTexture : public ::testing::Test {
 protected:
  // Fills a square from `low` to `high`, with `count` edgels per 4 px^2.
  void Fill(double low, double high, int count, double max_angle, double run_px) {
    testing::UniformDistribution<double> place(0, 2);
    testing::UniformDistribution<double> angle(0, max_angle);
    for (double y = low; y < high; y += 2) {
      for (double x = low; x < high; x += 2) {
        for (int i = 0; i < count; ++i) {
          const double a = angle(random_);
          edgels_.push_back(
              {{x + place(random_), y + place(random_)}, {std::cos(a), std::sin(a)}, run_px});
        }
      }
    }
  }

  std::vector<EdgelId> Find(double min_density = 0.18) const {
    return FindDenseTexture(edgels_, kTexturePx, kTexturePx, min_density);
  }

  std::mt19937 random_{7};
  std::vector<TextureSample> edgels_;
};

TEST_F(DenseTexture, IsDenseShortAndMixed) {
  Fill(20, 100, 1, M_PI, 5);
  const std::vector<EdgelId> texture = Find();
  EXPECT_TRUE(std::is_sorted(texture.begin(), texture.end()));
  EXPECT_GT(texture.size(), 0.75 * static_cast<double>(edgels_.size()));
  // Its rim has fewer around it.
  for (size_t id = 0; id < edgels_.size(); ++id) {
    const Eigen::Vector2d& px = edgels_[id].position_px;
    if (px.minCoeff() < 30 || px.maxCoeff() > 90) continue;
    EXPECT_TRUE(std::binary_search(texture.begin(), texture.end(), static_cast<EdgelId>(id)));
  }
}

TEST_F(DenseTexture, StrokesOfOneDirectionAreNone) {
  Fill(20, 100, 1, 0.5, 5);
  EXPECT_TRUE(Find().empty());
}

TEST_F(DenseTexture, WhatIsSparseIsNone) {
  Fill(20, 100, 1, M_PI, 5);
  EXPECT_TRUE(Find(0.3).empty()) << "a quarter per pixel";
  EXPECT_TRUE(Find(0).empty()) << "not asked for";
}

TEST_F(DenseTexture, LongRunsAreNone) {
  Fill(20, 100, 1, M_PI, 5);
  const auto first_long = static_cast<EdgelId>(edgels_.size());
  for (double x = 20; x < 100; ++x) edgels_.push_back({{x, 60}, {1, 0}, 80});
  const std::vector<EdgelId> texture = Find();
  EXPECT_FALSE(texture.empty());
  EXPECT_LT(texture.back(), first_long);
}

TEST_F(DenseTexture, AFewShortRunsAmongLongOnesAreNone) {
  Fill(20, 100, 1, M_PI, 5);
  Fill(20, 100, 2, M_PI, 40);
  EXPECT_TRUE(Find().empty());
}

// Blobs about 4 px wide on the left, a step from top to bottom on the right.
TEST(DenseTextureInImages, IsFoundWhereTheGrainIs) {
  Image image;
  image.width = image.height = 200;
  image.channels = 1;
  image.data.resize(size_t{200} * 200);
  std::mt19937 random(3);
  testing::UniformDistribution<double> phase(0, 2 * M_PI);
  struct Wave {
    double x, y, phase;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < 60; ++i) {
    const double direction = phase(random);
    waves.push_back({0.9 * std::cos(direction), 0.9 * std::sin(direction), phase(random)});
  }
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      double grain = 0;
      for (const Wave& wave : waves) grain += std::sin(wave.x * x + wave.y * y + wave.phase);
      image.data[static_cast<size_t>(y) * 200 + x] =
          static_cast<float>(x < 100 ? 120 + 5 * grain : (x < 150 ? 60 : 200));
    }
  }
  EdgeDetectionOptions options;
  options.texture_density = 0.15;
  const EdgeMap map = DetectEdges(image, options);
  ASSERT_GT(map.texture.size(), 500u);
  size_t num_of_step = 0;
  for (size_t id = 0; id < map.edgels.size(); ++id) {
    const bool is_texture =
        std::binary_search(map.texture.begin(), map.texture.end(), static_cast<EdgelId>(id));
    if (map.edgels[id].position_px.x() < 120) continue;
    ++num_of_step;
    EXPECT_FALSE(is_texture);
  }
  EXPECT_GT(num_of_step, 100u);
  EXPECT_TRUE(DetectEdges(image, {}).texture.empty()) << "not asked for";
}

}  // namespace
}  // namespace limn
