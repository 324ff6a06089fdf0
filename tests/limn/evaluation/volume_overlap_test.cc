// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/volume_overlap.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr double kSolidRadius = 0.5;
constexpr double kMaxChange = 1e-4;
// What is measured is that near.
constexpr double kShareError = 2e-4;

std::vector<EdgeSolid> SolidsOf(const std::vector<Eigen::Vector3d>& ends,
                                EdgeShape shape = EdgeShape::kCylinder) {
  Wireframe wireframe{ends, {}};
  for (size_t i = 0; i < ends.size(); i += 2) wireframe.edges.emplace_back(i, i + 1);
  return ThickenEdges(wireframe, shape, kSolidRadius);
}

VolumeOverlap OverlapOf(const std::vector<EdgeSolid>& first, const std::vector<EdgeSolid>& second) {
  return MeasureOverlap(first, second, kMaxChange);
}

double VolumeOf(const std::vector<EdgeSolid>& solids) { return OverlapOf(solids, {}).first; }

// Of two circles of the radius, their centers this far apart.
double LensArea(double distance) {
  const double r = kSolidRadius;
  return 2 * r * r * std::acos(distance / (2 * r)) -
         distance / 2 * std::sqrt(4 * r * r - distance * distance);
}

const double kDisc = M_PI * kSolidRadius * kSolidRadius;

TEST(EdgeSolids, ChordsAreExact) {
  const EdgeSolid cylinder = SolidsOf({{0, 0, 0}, {4, 0, 0}}).at(0);
  const auto chord = ChordAlongZ(cylinder, 1, 0.3);
  ASSERT_TRUE(chord);
  EXPECT_NEAR(chord->first, -0.4, 1e-12);
  EXPECT_NEAR(chord->second, 0.4, 1e-12);
  EXPECT_FALSE(ChordAlongZ(cylinder, 1, 0.51));
  EXPECT_FALSE(ChordAlongZ(cylinder, 4.01, 0));
  EXPECT_FALSE(ChordAlongZ(cylinder, -0.01, 0));
  const EdgeSolid upright = SolidsOf({{0, 0, 1}, {0, 0, 3}}).at(0);
  EXPECT_EQ(ChordAlongZ(upright, 0.3, 0.3), std::pair(1.0, 3.0));
  EXPECT_FALSE(ChordAlongZ(upright, 0.4, 0.4));
  // At 45 degrees, through the middle of the axis: radius / sin 45 to both sides.
  const auto slanted = ChordAlongZ(SolidsOf({{0, 0, 0}, {4, 0, 4}}).at(0), 2, 0);
  ASSERT_TRUE(slanted);
  EXPECT_NEAR(slanted->first, 2 - std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(slanted->second, 2 + std::sqrt(0.5), 1e-12);
}

TEST(EdgeSolids, EdgesOfNoLengthAndCopiesHaveNone) {
  EXPECT_THAT(SolidsOf({{1, 1, 1}, {1, 1, 1}, {0, 0, 0}, {9e-7, 0, 0}}), IsEmpty());
  EXPECT_EQ(SolidsOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}).size(),
            1u);
}

TEST(VolumeOverlap, OfOneCylinderIsItsVolume) {
  for (const Eigen::Vector3d& end :
       {Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(2, 1, -2)}) {
    EXPECT_NEAR(VolumeOf(SolidsOf({{0, 0, 0}, end})), 3 * kDisc, 1e-3) << end;
  }
}

TEST(VolumeOverlap, OfACylinderThatIsShiftedAlongIt) {
  for (const double shift : {0.25, 1.0, 2.5}) {
    const VolumeOverlap overlap =
        OverlapOf(SolidsOf({{0, 0, 0}, {3, 0, 0}}), SolidsOf({{shift, 0, 0}, {3 + shift, 0, 0}}));
    EXPECT_NEAR(overlap.Share(), (3 - shift) / (3 + shift), kShareError);
    EXPECT_NEAR(overlap.common, (3 - shift) * kDisc, 1e-3);
    EXPECT_LE(overlap.share_change, kMaxChange);
  }
}

TEST(VolumeOverlap, OfACylinderThatIsShiftedAcross) {
  for (const double shift : {0.1, 0.5, 0.9}) {
    const double lens = LensArea(shift);
    EXPECT_NEAR(
        OverlapOf(SolidsOf({{0, 0, 0}, {2, 2, 0}}), SolidsOf({{0, 0, shift}, {2, 2, shift}}))
            .Share(),
        lens / (2 * kDisc - lens), kShareError);
  }
  EXPECT_EQ(
      OverlapOf(SolidsOf({{0, 0, 0}, {2, 2, 0}}), SolidsOf({{0, 0, 1.01}, {2, 2, 1.01}})).Share(),
      0);
}

TEST(VolumeOverlap, WhatIsInSeveralCylindersCountsOnce) {
  // Two that cross have 16 / 3 r^3 in common (Archimedes).
  const double crossing = 16 * std::pow(kSolidRadius, 3) / 3;
  const std::vector<Eigen::Vector3d> along_x = {{-2, 0, 0}, {2, 0, 0}};
  const std::vector<Eigen::Vector3d> along_y = {{0, -2, 0}, {0, 2, 0}};
  EXPECT_NEAR(OverlapOf(SolidsOf(along_x), SolidsOf(along_y)).common, crossing, 1e-3);
  std::vector<Eigen::Vector3d> both = along_x;
  both.insert(both.end(), along_y.begin(), along_y.end());
  EXPECT_NEAR(VolumeOf(SolidsOf(both)), 8 * kDisc - crossing, 1e-3);
  EXPECT_NEAR(OverlapOf(SolidsOf(both), SolidsOf(along_x)).Share(),
              4 * kDisc / (8 * kDisc - crossing), kShareError);
  // A piece of an edge in two or in one.
  EXPECT_NEAR(OverlapOf(SolidsOf({{0, 0, 0}, {3, 0, 0}}),
                        SolidsOf({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}}))
                  .Share(),
              1, 1e-9);
}

// A hexagon of corners at the radius, across an edge along an axis.
TEST(VolumeOverlap, OfThePrismsOfTheChallenge) {
  const double hexagon = 1.5 * std::sqrt(3.0) * kSolidRadius * kSolidRadius;
  const auto volume = [](const Eigen::Vector3d& end) {
    return VolumeOf(SolidsOf({{0, 0, 0}, end}, EdgeShape::kHoho2025));
  };
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0),
                                      Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(0, 1.8, 2.4)}) {
    EXPECT_NEAR(volume(axis), 3 * hexagon, 2e-3) << axis;
  }
  // Oblique ones shrink by the smaller of their x and y.
  EXPECT_NEAR(volume({3 * std::sqrt(0.5), 3 * std::sqrt(0.5), 0}), 3 * hexagon / 2, 2e-3);
  EXPECT_NEAR(volume({1, 2, 2}), 3 * hexagon * (1 - 1.0 / 9), 2e-3);
  EXPECT_NEAR(volume({2, 1, 2}), 3 * hexagon * (1 - 1.0 / 9), 2e-3);
}

std::vector<Eigen::Vector3d> RandomEnds(int num_edges, unsigned seed) {
  std::mt19937 random(seed);
  testing::UniformDistribution<double> coordinate(0, 6);
  std::vector<Eigen::Vector3d> ends;
  for (int i = 0; i < 2 * num_edges; ++i) {
    ends.push_back(testing::RandomVector(coordinate, random));
  }
  return ends;
}

TEST(VolumeOverlap, IsSymmetricAndDoesNotDependOnOrderOrThreads) {
  for (const EdgeShape shape : {EdgeShape::kCylinder, EdgeShape::kHoho2025}) {
    const auto first = SolidsOf(RandomEnds(8, 1), shape);
    auto second = SolidsOf(RandomEnds(7, 2), shape);
    const VolumeOverlap overlap = OverlapOf(first, second);
    EXPECT_GT(overlap.Share(), 0.04);
    EXPECT_EQ(OverlapOf(second, first).Share(), overlap.Share());
    std::ranges::reverse(second);
    RunContext one_thread;
    one_thread.num_threads = 1;
    EXPECT_EQ(MeasureOverlap(first, second, kMaxChange, one_thread).Share(), overlap.Share());
    EXPECT_EQ(OverlapOf(first, first).Share(), 1);
  }
}

TEST(VolumeOverlap, DoesNotDependOnTheFrame) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  // Where a map grid has it.
  const Eigen::Vector3d far(4.5e5, 5.4e6, 300);
  std::vector<EdgeSolid> moved[2], here[2];
  for (const int i : {0, 1}) {
    std::vector<Eigen::Vector3d> ends = RandomEnds(6, 3 + i);
    here[i] = SolidsOf(ends);
    for (Eigen::Vector3d& end : ends) end = turn * end + far;
    moved[i] = SolidsOf(ends);
  }
  EXPECT_NEAR(OverlapOf(moved[0], moved[1]).Share(), OverlapOf(here[0], here[1]).Share(),
              kShareError);
}

TEST(VolumeOverlap, DenserLinesAreNearerToTheTruth) {
  const double truth = LensArea(0.3) / (2 * kDisc - LensArea(0.3));
  const auto first = SolidsOf({{0, 0, 0}, {1, 0, 0}}),
             second = SolidsOf({{0, 0.3, 0}, {1, 0.3, 0}});
  EXPECT_NEAR(MeasureOverlap(first, second, 1e-6).Share(), truth, 1e-5);
}

TEST(VolumeOverlap, OfNothing) {
  const auto some = SolidsOf({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(OverlapOf({}, {}).Share(), 0);
  EXPECT_EQ(OverlapOf(some, {}).Share(), 0);
  EXPECT_EQ(OverlapOf({}, some).Share(), 0);
  EXPECT_GT(OverlapOf({}, some).second, 0);
}

TEST(VolumeOverlap, RefusesEdgesThatAreTooLongForTheirRadius) {
  const auto endless = SolidsOf({{0, 0, 0}, {1e9, 0, 0}});
  EXPECT_THAT([&] { OverlapOf(endless, endless); },
              ThrowsMessage<InputError>(HasSubstr("is the scale right?")));
}

// Neither time nor memory for what is between.
TEST(VolumeOverlap, EdgesMayBeFarApart) {
  const Wireframe near{{{0, 0, 0}, {10, 0, 0}}, {{0, 1}}};
  Wireframe far = near;
  for (Eigen::Vector3d& vertex : far.vertices) vertex += Eigen::Vector3d(5e6, 5e6, 0);
  const VolumeOverlap overlap = MeasureOverlap(ThickenEdges(near, EdgeShape::kCylinder, 0.5),
                                               ThickenEdges(far, EdgeShape::kCylinder, 0.5), 1e-4);
  EXPECT_EQ(overlap.Share(), 0);
  EXPECT_NEAR(overlap.first, overlap.second, 1e-2 * overlap.first);
  for (Eigen::Vector3d& vertex : far.vertices) vertex *= 1e12;
  EXPECT_THROW(MeasureOverlap(ThickenEdges(near, EdgeShape::kCylinder, 0.5),
                              ThickenEdges(far, EdgeShape::kCylinder, 0.5), 1e-4),
               InputError);
}

}  // namespace
}  // namespace limn
