// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/position_check.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using testing::RandomDirection;
using testing::RandomSimilarity;

constexpr int kNumSeeds = 12;

// Cameras around a scene of radius 8 at different heights, and their positions with noise.
std::vector<PointPair> AroundAScene(int count, double noise, unsigned seed) {
  std::mt19937 random(seed);
  testing::NormalDistribution<double> normal;
  testing::UniformDistribution<double> uniform;
  const Similarity3d target_from_source = RandomSimilarity(2, seed);
  std::vector<PointPair> pairs;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2 * M_PI * uniform(random), radius = 6 + 4 * uniform(random);
    const Eigen::Vector3d at(radius * std::cos(azimuth), radius * std::sin(azimuth),
                             5 * uniform(random));
    const Eigen::Vector3d error = testing::RandomVector(normal, random);
    pairs.push_back({Inverse(target_from_source) * at, at + noise * error});
  }
  return pairs;
}

PositionDoubt DoubtOf(const std::vector<PointPair>& pairs, double accuracy = 0,
                      const std::vector<PointPair>& exchanged = {}) {
  return CheckPositions(pairs, *FitPositions(pairs), exchanged, accuracy).doubt;
}

// How many of the seeds end in this doubt.
template <typename Change>
int Count(PositionDoubt doubt, int num_pairs, double noise, const Change& change) {
  int count = 0;
  for (unsigned seed = 1; seed <= kNumSeeds; ++seed) {
    std::vector<PointPair> pairs = AroundAScene(num_pairs, noise, seed);
    change(seed, &pairs);
    count += DoubtOf(pairs) == doubt;
  }
  return count;
}

void Keep(unsigned, std::vector<PointPair>*) {}

TEST(PositionCheck, BelievesConsistentPositions) {
  for (const int count : {4, 5, 8, 24}) {
    for (const double noise : {0.0, 0.1, 1.0}) {
      EXPECT_GE(Count(PositionDoubt::kNone, count, noise, Keep), kNumSeeds - 1)
          << count << " with noise " << noise;
    }
  }
}

TEST(PositionCheck, BelievesTheRestBesideWrongOnes) {
  const auto change = [](unsigned seed, std::vector<PointPair>* pairs) {
    std::mt19937 random(seed);
    for (size_t i = 0; i < pairs->size(); i += 5) {
      (*pairs)[i].target += 30 * RandomDirection(&random);
    }
  };
  for (const int count : {12, 24}) {
    EXPECT_EQ(Count(PositionDoubt::kNone, count, 0.1, change), kNumSeeds) << count;
  }
}

TEST(PositionCheck, NamesMirrorImages) {
  const auto change = [](unsigned seed, std::vector<PointPair>* pairs) {
    for (PointPair& pair : *pairs) pair.target[seed % 3] *= -1;
  };
  for (const int count : {8, 24}) {
    for (const double noise : {0.0, 0.1}) {
      EXPECT_GE(Count(PositionDoubt::kMirrored, count, noise, change), kNumSeeds - 1)
          << count << " with noise " << noise;
    }
  }
}

TEST(PositionCheck, NamesOtherUnitsOfAnAxis) {
  const auto change = [](unsigned seed, std::vector<PointPair>* pairs) {
    for (PointPair& pair : *pairs) pair.target[seed % 3] /= 0.3048;
  };
  for (const int count : {8, 24}) {
    EXPECT_GE(Count(PositionDoubt::kStretched, count, 0.05, change), kNumSeeds - 1) << count;
  }
  const std::vector<PointPair> pairs = [&] {
    std::vector<PointPair> stretched = AroundAScene(24, 0, 3);
    change(2, &stretched);
    return stretched;
  }();
  const PositionCheck check = CheckPositions(pairs, *FitPositions(pairs), {}, 0);
  EXPECT_NEAR(check.stretch[0] / check.stretch[1], 1 / 0.3048, 1e-6);
  EXPECT_NEAR(check.stretch[1] / check.stretch[2], 1, 1e-6);
  EXPECT_LT(check.other_residual, 1e-6);
}

TEST(PositionCheck, NamesPositionsOfOtherImages) {
  const auto change = [](unsigned seed, std::vector<PointPair>* pairs) {
    std::mt19937 random(seed);
    std::vector<PointPair> shuffled = *pairs;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    for (size_t i = 0; i < pairs->size(); ++i) (*pairs)[i].target = shuffled[i].target;
  };
  for (const int count : {8, 12, 24, 60}) {
    EXPECT_GE(Count(PositionDoubt::kAnyOrder, count, 0.02, change), kNumSeeds - 2) << count;
  }
}

TEST(PositionCheck, NoiseWithinTheAccuracyIsNoContradiction) {
  const std::vector<PointPair> pairs = AroundAScene(12, 30, 1);
  EXPECT_EQ(DoubtOf(pairs), PositionDoubt::kAnyOrder);
  EXPECT_EQ(DoubtOf(pairs, 20), PositionDoubt::kNone);
}

TEST(PositionCheck, TooManyWrongOnesAreNamed) {
  std::vector<PointPair> pairs = AroundAScene(24, 0.05, 1);
  std::mt19937 random(1);
  for (size_t i = 0; i < pairs.size(); i += 2) pairs[i].target += 30 * RandomDirection(&random);
  pairs[0] = pairs[1];
  EXPECT_EQ(DoubtOf(pairs), PositionDoubt::kManyWrong);
}

TEST(PositionCheck, ExchangedCoordinatesThatFitAreNamed) {
  const std::vector<PointPair> right = AroundAScene(12, 0.1, 1);
  std::vector<PointPair> wrong = right;
  for (PointPair& pair : wrong) {
    pair.target = {1.5 * pair.target.y(), 0.9 * pair.target.x(), pair.target.z()};
  }
  EXPECT_EQ(DoubtOf(wrong, 10, right), PositionDoubt::kExchanged);
  EXPECT_EQ(DoubtOf(right, 10, wrong), PositionDoubt::kNone);
}

TEST(PositionCheck, CamerasOnAPlaneOrALineAreNoMirrorImages) {
  for (const int dimensions : {1, 2}) {
    for (unsigned seed = 1; seed <= kNumSeeds; ++seed) {
      std::vector<PointPair> pairs = AroundAScene(12, 0, seed);
      std::mt19937 random(seed);
      for (PointPair& pair : pairs) {
        pair.target.tail(3 - dimensions).setZero();
        pair.source = pair.target;
        pair.target += 0.05 * RandomDirection(&random);
      }
      EXPECT_EQ(DoubtOf(pairs), PositionDoubt::kNone) << dimensions << " " << seed;
    }
  }
}

}  // namespace
}  // namespace limn
