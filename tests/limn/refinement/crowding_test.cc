// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/crowding.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

ImagePlace At(int link, const Eigen::Vector2d& pixel, double angle) {
  return {link, pixel, {std::cos(angle), std::sin(angle)}};
}

TEST(Crowding, OnlyOtherParallelLinksCount) {
  const Crowding crowding({At(0, {10, 10}, 0), At(1, {10, 12}, 0.1), At(2, {10, 7.5}, 1.5)});
  EXPECT_TRUE(crowding.At(At(0, {10, 10}, 0), 3, 1.5));
  EXPECT_FALSE(crowding.At(At(0, {10, 10}, 0), 1.9, 1.5));
  // Undirected.
  EXPECT_TRUE(crowding.At(At(0, {10, 10}, M_PI), 3, 1.5));
  // Link 2 is near, but crosses.
  EXPECT_FALSE(crowding.At(At(1, {10, 6}, 0), 3, 1.5));
  EXPECT_TRUE(crowding.At(At(1, {10, 6}, 1.5), 3, 1.5));
  // What passes at a distance has its next places ahead or behind.
  EXPECT_TRUE(crowding.At(At(0, {11.4, 10}, 0.1), 2.3, 1.5));
  EXPECT_FALSE(crowding.At(At(0, {14, 10}, 0.1), 2.3, 1.5));
}

TEST(Crowding, FindsWhatComparingAllPairsFinds) {
  std::mt19937 random(3);
  testing::UniformDistribution<double> uniform(-40, 40);
  std::vector<ImagePlace> places;
  for (int i = 0; i < 400; ++i) places.push_back(At(i % 7, {uniform(random), uniform(random)}, 0));
  const Crowding crowding(places);
  int num_crowded = 0;
  for (const ImagePlace& place : places) {
    bool expected = false;
    for (const ImagePlace& other : places) {
      const Eigen::Vector2d offset = other.pixel - place.pixel;  // all run along x
      expected |= other.link != place.link && offset.norm() <= std::hypot(2.5, 1.5) &&
                  std::abs(offset.y()) <= 2.5;
    }
    EXPECT_EQ(crowding.At(place, 2.5, 1.5), expected);
    num_crowded += expected;
  }
  EXPECT_GT(num_crowded, 50);
  EXPECT_LT(num_crowded, 350);
}

TEST(Crowding, NoPlacesCrowdNothing) { EXPECT_FALSE(Crowding({}).At(At(0, {1, 1}, 0), 3, 1.5)); }

}  // namespace
}  // namespace limn
