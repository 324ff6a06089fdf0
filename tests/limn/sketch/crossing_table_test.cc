// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/crossing_table.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

constexpr double kGatePx = 1.5;
constexpr double kGateRad = 0.25;

float SquaredGates(const EpipolarCrossing& crossing, const DepthPlace& place) {
  const double offset = (crossing.inverse_depth - place.inverse_depth) *
                        crossing.across_px_per_inverse_depth / kGatePx;
  const double turn =
      (crossing.slope_per_px - place.slope_per_px) * crossing.rad_per_slope / kGateRad;
  return static_cast<float>(offset * offset + turn * turn);
}

// Some across the epipolar line, some nearly along it.
std::vector<EpipolarCrossing> RandomCrossings(int count, std::mt19937* random) {
  testing::UniformDistribution<float> uniform(0, 1);
  std::vector<EpipolarCrossing> crossings(count);
  for (EpipolarCrossing& crossing : crossings) {
    crossing.inverse_depth = 0.1f + 0.3f * uniform(*random);
    crossing.slope_per_px = 1e-3f * (uniform(*random) - 0.5f);
    crossing.across_px_per_inverse_depth = 2000 * std::pow(10.f, -2.5f * uniform(*random));
    crossing.rad_per_slope = crossing.across_px_per_inverse_depth;
  }
  return crossings;
}

// Cameras of any distance: what overflows indexes nothing.
TEST(CrossingTableTest, TakesNumbersOfAllMagnitudes) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::mt19937 random(7);
  CrossingTable table(kGatePx, kGateRad);
  for (const float odd : {kInfinity, -kInfinity, std::nanf(""), 3e38f, -3e38f, 1e-45f, 0.f}) {
    auto crossings = RandomCrossings(40, &random);
    crossings[3].inverse_depth = odd;
    crossings[5].inverse_depth = -odd;
    crossings[7].across_px_per_inverse_depth = std::abs(odd);
    crossings[9].rad_per_slope = odd;
    table.Fill(crossings);
    for (const float depth : {0.2f, odd, -odd, 0.f}) {
      table.ForEachNear({depth, 0}, [](int i, float) {
        EXPECT_GE(i, 0);
        EXPECT_LT(i, 40);
      });
    }
  }
}

TEST(CrossingTableTest, FindsWhatAcceptsAPlace) {
  std::mt19937 random(7);
  CrossingTable table(kGatePx, kGateRad);
  size_t num_found = 0;
  for (const int count : {0, 1, 7, 40, 300}) {
    const auto crossings = RandomCrossings(count, &random);
    table.Fill(crossings);
    // Also places outside of all the depths.
    for (const EpipolarCrossing& at : RandomCrossings(200, &random)) {
      const DepthPlace place = {1.4f * at.inverse_depth - 0.1f, at.slope_per_px};
      std::set<int> expected, found, undecided;
      for (int i = 0; i < count; ++i) {
        const float distance = SquaredGates(crossings[i], place);
        if (std::abs(distance - 1) < 1e-4f) undecided.insert(i);
        if (distance < 1 && !undecided.contains(i)) expected.insert(i);
      }
      table.ForEachNear(place, [&](int i, float distance) {
        EXPECT_NEAR(distance, SquaredGates(crossings[i], place), 1e-4);
        if (!undecided.contains(i)) found.insert(i);
      });
      EXPECT_EQ(found, expected);
      num_found += found.size();
    }
  }
  EXPECT_GT(num_found, 1000u);
}

TEST(CrossingTableTest, CrossingsOfOneDepth) {
  EpipolarCrossing crossing;
  crossing.inverse_depth = 0.2f;
  crossing.across_px_per_inverse_depth = crossing.rad_per_slope = 1000;
  CrossingTable table(kGatePx, kGateRad);
  table.Fill(std::vector<EpipolarCrossing>(11, crossing));
  std::set<int> found;
  table.ForEachNear({0.2f, 0}, [&](int i, float) { found.insert(i); });
  EXPECT_EQ(found.size(), 11u);
  table.ForEachNear({0.21f, 0}, [&](int, float) { ADD_FAILURE() << "10 px away"; });
}

}  // namespace
}  // namespace limn
