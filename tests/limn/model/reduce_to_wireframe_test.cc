// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/reduce_to_wireframe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::ThrowsMessage;
using ::testing::UnorderedElementsAre;

constexpr double kWireTolerance = 0.1;

Wireframe Reduced(const std::vector<Polyline3d>& lines, double tolerance = kWireTolerance) {
  WireframeOptions options;
  options.tolerance = tolerance;
  return ReduceToWireframe(lines, options);
}

double DistanceTo(const Wireframe& wireframe, const Eigen::Vector3d& point) {
  double squared = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : wireframe.edges) {
    const Polyline3d edge = {wireframe.vertices[a], wireframe.vertices[b]};
    squared = std::min(squared, ClosestPoint(edge, point).squared_distance);
  }
  return std::sqrt(squared);
}

// Of points up to 0.01 apart.
double GreatestDistance(const Wireframe& wireframe, const std::vector<Polyline3d>& lines) {
  double greatest = 0;
  for (const Polyline3d& line : lines) {
    for (const Eigen::Vector3d& point : ResampleUniform(line, 0.01)) {
      greatest = std::max(greatest, DistanceTo(wireframe, point));
    }
  }
  return greatest;
}

Polyline3d WiggledLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double across) {
  Polyline3d line;
  for (int i = 0; i <= 20; ++i) {
    line.push_back(from + i / 20.0 * (to - from));
    if (i > 0 && i < 20) line.back().z() += i % 2 == 0 ? across : -across;
  }
  return line;
}

Polyline3d CircleOf(double radius, int count) {
  Polyline3d circle;
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * M_PI * (i % count) / count;
    circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return circle;
}

TEST(ReduceToWireframe, WhatIsStraightWithinHalfTheToleranceIsOneEdge) {
  const Wireframe straight = Reduced({WiggledLine({0, 0, 0}, {2, 0, 0}, 0.049)});
  EXPECT_THAT(straight.vertices, ElementsAre(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 0, 0)));
  EXPECT_THAT(straight.edges, ElementsAre(Pair(0, 1)));
  EXPECT_GT(Reduced({WiggledLine({0, 0, 0}, {4, 0, 0}, 0.051)}).edges.size(), 1u);
}

TEST(ReduceToWireframe, OfACircleIsAPolygon) {
  const std::vector<Polyline3d> circle = {CircleOf(1, 400)};
  const Wireframe wireframe = Reduced(circle);
  // A chord over 2 a leaves the circle by 1 - cos a: by 0.05 at a = 18.2 degrees.
  EXPECT_GE(wireframe.edges.size(), 10u);
  EXPECT_LE(wireframe.edges.size(), 16u);
  EXPECT_EQ(wireframe.vertices.size(), wireframe.edges.size());
  EXPECT_LE(GreatestDistance(wireframe, circle), kWireTolerance / 2);
}

TEST(ReduceToWireframe, CornersWithinTheToleranceAreOneThatHasMostEdges) {
  // Two lines meet at (0, 0, 0.05); three others end nearby.
  const Eigen::Vector3d meeting(0, 0, 0.05);
  const Wireframe wireframe = Reduced({{{1, 0, 0}, meeting},
                                       {{0, 1, 0}, meeting},
                                       {{-1, 0, 0}, {0, 0, 0}},
                                       {{0, -1, 0}, {0.04, -0.03, 0}},
                                       {{0, 0, 1}, {0, 0, 0.15}}});
  ASSERT_EQ(wireframe.vertices.size(), 6u);
  EXPECT_EQ(std::ranges::count(wireframe.vertices, meeting), 1);
  EXPECT_EQ(wireframe.edges.size(), 5u);
  for (const auto& [a, b] : wireframe.edges) {
    EXPECT_TRUE(wireframe.vertices[a] == meeting || wireframe.vertices[b] == meeting);
  }
}

TEST(ReduceToWireframe, CornersFartherApartStayTwo) {
  EXPECT_EQ(Reduced({{{0, 0, 0}, {1, 0, 0}}, {{1.099, 0, 0}, {1.099, 1, 0}}}).vertices.size(), 3u);
  EXPECT_EQ(Reduced({{{0, 0, 0}, {1, 0, 0}}, {{1.101, 0, 0}, {1.101, 1, 0}}}).vertices.size(), 4u);
}

TEST(ReduceToWireframe, ShortEdgesCollapseAndEqualOnesAreDropped) {
  // Four edges meet on either side of a short one.
  const Wireframe wireframe = Reduced({{{0, 0, 0}, {0.09, 0, 0}},
                                       {{0, 0, 0}, {-1, 1, 0}},
                                       {{0, 0, 0}, {-1, -1, 0}},
                                       {{0.09, 0, 0}, {1, 1, 0}},
                                       {{0.09, 0, 0}, {1, -1, 0}}});
  EXPECT_EQ(wireframe.vertices.size(), 5u);
  EXPECT_EQ(wireframe.edges.size(), 4u);
  // Copies of a line, one of them turned around.
  EXPECT_EQ(Reduced({{{0, 0, 0}, {1, 0, 0}},
                     {{1, 0.01, 0}, {0, 0.02, 0}},
                     {{0, 0, 0.05}, {0.5, 0, 0.05}, {1, 0, 0.05}}})
                .edges.size(),
            1u);
  EXPECT_THAT(Reduced({CircleOf(0.04, 20)}).edges, IsEmpty());
}

TEST(ReduceToWireframe, CollinearEdgesAreOneEvenThoughLinesEndThere) {
  const Wireframe wireframe =
      Reduced({{{0, 0, 0}, {1, 0, 0}}, {{2, 0.02, 0}, {1, 0, 0}}, {{2, 0.02, 0}, {3, 0, 0}}});
  EXPECT_THAT(wireframe.vertices, ElementsAre(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0)));
  // Where a third one ends there is a corner.
  EXPECT_EQ(Reduced({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {1, 1, 0}}})
                .vertices.size(),
            4u);
  // Also if that is in the middle of a line.
  EXPECT_EQ(Reduced({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {1, 1, 0}}}).vertices.size(),
            4u);
}

TEST(ReduceToWireframe, AClosedLineHasCornersWhereItBends) {
  const Wireframe square = Reduced(
      {{{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.3, 0}, {0, 0, 0}, {0.5, 0, 0}}});
  EXPECT_THAT(square.vertices, ElementsAre(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 1, 0),
                                           Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0)));
  EXPECT_THAT(square.edges, UnorderedElementsAre(Pair(0, 1), Pair(0, 2), Pair(1, 3), Pair(2, 3)));
  // A line that ends on its side stays joined to it.
  const Wireframe handle =
      Reduced({{{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0.5, 0, 0}},
               {{0.5, 0, 0}, {0.5, -1, 0}}});
  EXPECT_EQ(handle.vertices.size(), 6u);
  EXPECT_EQ(handle.edges.size(), 6u);
}

// A net of noisy lines between corners that are hit with noise.
std::vector<Polyline3d> NoisyNet(std::mt19937* random) {
  testing::UniformDistribution<double> coordinate(-1, 1);
  const auto noise = [&](double size) {
    return Eigen::Vector3d(size * testing::RandomVector(coordinate, *random));
  };
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 12; ++i) corners.push_back(noise(2));
  std::vector<Polyline3d> lines;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d from = corners[(*random)() % 12] + noise(0.04);
    const Eigen::Vector3d to = corners[(*random)() % 12] + noise(0.04);
    Polyline3d line;
    for (int k = 0; k <= 15; ++k) line.push_back(from + k / 15.0 * (to - from) + noise(0.02));
    lines.push_back(line);
    // One that goes on where it ends.
    lines.push_back({line.back(), line.back() + noise(1)});
  }
  return lines;
}

TEST(ReduceToWireframe, IsWithinTwoTolerancesAndHasNoShortOrEqualEdges) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polyline3d> lines = NoisyNet(&random);
    const Wireframe wireframe = Reduced(lines);
    // What is smaller than the tolerance may vanish.
    std::erase_if(lines, [](const Polyline3d& line) { return Length(line) < 2 * kWireTolerance; });
    EXPECT_LE(GreatestDistance(wireframe, lines), 2 * kWireTolerance);
    std::set<std::pair<int, int>> seen;
    for (const auto& [a, b] : wireframe.edges) {
      EXPECT_LT(a, b);
      EXPECT_TRUE(seen.insert({a, b}).second);
    }
    for (size_t i = 0; i < wireframe.vertices.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        EXPECT_GT((wireframe.vertices[i] - wireframe.vertices[j]).norm(), kWireTolerance);
      }
    }
  }
}

TEST(ReduceToWireframe, DoesNotDependOnOrderDirectionsAndCuts) {
  std::mt19937 random(4);
  std::vector<Polyline3d> lines = NoisyNet(&random);
  lines.push_back(CircleOf(1.5, 100));
  const Wireframe wireframe = Reduced(lines);
  std::vector<Polyline3d> others;
  for (const Polyline3d& line : lines) {
    const size_t cut = line.size() / 3;
    others.emplace_back(line.begin(), line.begin() + cut + 1);
    others.emplace_back(line.rbegin(), line.rend() - cut);
  }
  std::ranges::shuffle(others, random);
  const Wireframe other = Reduced(others);
  EXPECT_EQ(other.vertices, wireframe.vertices);
  EXPECT_EQ(other.edges, wireframe.edges);
}

TEST(ReduceToWireframe, DefaultToleranceIsAHundredthOfTheScene) {
  // A box of 3 x 4 x 12 has a diagonal of 13.
  std::vector<Polyline3d> box;
  for (const double x : {0, 3}) {
    for (const double y : {0, 4}) box.push_back({{x, y, 0}, {x, y, 12}});
    for (const double z : {0, 12}) box.push_back({{x, 0, z}, {x, 4, z}});
  }
  for (const double y : {0, 4}) {
    for (const double z : {0, 12}) box.push_back({{0, y, z}, {3, y, z}});
  }
  EXPECT_NEAR(DefaultWireframeTolerance(box), 0.13, 1e-12);
  // A stray curve of less than 2 % of the length does not count, a longer one does.
  box.push_back({{100, 0, 0}, {101, 0, 0}});
  EXPECT_NEAR(DefaultWireframeTolerance(box), 0.13, 1e-12);
  box.push_back({{100, 1, 0}, {110, 1, 0}});
  EXPECT_GT(DefaultWireframeTolerance(box), 1);
  EXPECT_EQ(DefaultWireframeTolerance({}), 0);
  // It is what 0 stands for.
  const std::vector<Polyline3d> lines = {CircleOf(1, 400)};
  EXPECT_EQ(Reduced(lines, 0).vertices, Reduced(lines, DefaultWireframeTolerance(lines)).vertices);
}

TEST(ReduceToWireframe, OfNothingAndOfPoints) {
  EXPECT_THAT(Reduced({}).vertices, IsEmpty());
  EXPECT_THAT(Reduced({}, 0).vertices, IsEmpty());
  EXPECT_THAT(Reduced({{{1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}, {}}, 0).vertices, IsEmpty());
}

TEST(ReduceToWireframe, RefusesWhatItCannotReduce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        Reduced({{{0, 0, 0}, {nan, 0, 0}}});
      },
      ThrowsMessage<InputError>(HasSubstr("not finite")));
  EXPECT_THAT(
      [&] {
        Reduced({{{0, 0, 0}, {1, 0, 0}}}, -1);
      },
      ThrowsMessage<OptionError>(HasSubstr("tolerance = -1")));
}

}  // namespace
}  // namespace limn
