// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/dominant_directions.h"

#include <random>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using testing::AngleDeg;

std::vector<StraightLine> RandomLines(int count) {
  std::mt19937 random(1);
  std::vector<StraightLine> lines;
  for (int i = 0; i < count; ++i) {
    lines.push_back({testing::RandomDirection(&random), testing::RandomDirection(&random), 1});
  }
  return lines;
}

// Off by a degree or so.
void AddNoise(std::vector<StraightLine>* lines) {
  std::mt19937 random(1);
  for (StraightLine& line : *lines) {
    line.direction = (line.direction + 0.01 * testing::RandomDirection(&random)).normalized();
  }
}

TEST(DominantDirections, OfATiltedRoom) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Similarity3d tilt = testing::RandomSimilarity(0.7, seed);
    const auto lines = StraightLines(testing::Moved(testing::WireRoom(), tilt));
    // At most 40 degrees from it.
    const auto vertical = FindVertical(lines, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(vertical);
    const Eigen::Vector3d up = tilt.rotation.col(2);
    EXPECT_LT(AngleDeg(vertical->direction, up), 1e-3);
    EXPECT_LT(vertical->deviation_rad, 1e-5);
    EXPECT_GT(vertical->share, 0.9);
    const auto horizontal = FindHorizontal(lines, up, Eigen::Vector3d::UnitX());
    ASSERT_TRUE(horizontal);
    EXPECT_LT(AngleDeg(horizontal->direction, tilt.rotation.col(0)), 1e-3);
  }
}

TEST(DominantDirections, OfLinesWithNoise) {
  std::vector<StraightLine> lines = StraightLines(testing::WireRoom());
  AddNoise(&lines);
  const auto vertical = FindVertical(lines, Eigen::Vector3d(0.3, 0.2, 1).normalized());
  ASSERT_TRUE(vertical);
  EXPECT_LT(AngleDeg(vertical->direction, Eigen::Vector3d::UnitZ()), 0.3);
  const auto horizontal = FindHorizontal(lines, vertical->direction, Eigen::Vector3d::UnitY());
  ASSERT_TRUE(horizontal);
  EXPECT_LT(AngleDeg(horizontal->direction, Eigen::Vector3d::UnitY()), 0.3);
}

TEST(DominantDirections, TheHintTellsWhichOfThemIsUp) {
  const auto lines = StraightLines(testing::WireRoom());
  const auto down = FindVertical(lines, Eigen::Vector3d(0.3, 0.2, -1).normalized());
  ASSERT_TRUE(down);
  EXPECT_LT(AngleDeg(down->direction, -Eigen::Vector3d::UnitZ()), 1e-3);
  const auto side = FindVertical(lines, Eigen::Vector3d(1, 0.2, 0.3).normalized());
  ASSERT_TRUE(side);
  EXPECT_LT(AngleDeg(side->direction, Eigen::Vector3d::UnitX()), 1e-3);
}

TEST(DominantDirections, OfAFloorWithoutWalls) {
  DrawingGraph graph;
  for (int i = 0; i < 8; ++i) {
    testing::AddLine({0.2 * i, 0, 0}, {0.2 * i, 2, 0}, &graph);
    testing::AddLine({0, 0.2 * i, 0}, {2, 0.2 * i, 0}, &graph);
    testing::AddLine({0, 0.2 * i, 0}, {2, 2 - 0.2 * i, 0}, &graph);
  }
  const auto vertical =
      FindVertical(StraightLines(graph), Eigen::Vector3d(0.3, 0.2, 1).normalized());
  ASSERT_TRUE(vertical);
  EXPECT_LT(AngleDeg(vertical->direction, Eigen::Vector3d::UnitZ()), 1e-3);
}

TEST(DominantDirections, LinesOfAllDirectionsHaveNone) {
  const std::vector<StraightLine> lines = RandomLines(300);
  EXPECT_FALSE(FindVertical(lines, Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(FindHorizontal(lines, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()));
  EXPECT_FALSE(FindVertical({}, Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(FindHorizontal({}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()));
}

TEST(DominantDirections, TheFloorIsTheLowestLevelThatHoldsLines) {
  DrawingGraph graph = testing::WireRoom();
  testing::AddLine({0, 0, -0.5}, {0.1, 0, -0.5}, &graph);  // a scrap below it
  const auto floor = FloorHeight(StraightLines(graph), Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(floor);
  EXPECT_NEAR(*floor, 0, 1e-3);
  EXPECT_FALSE(FloorHeight({}, Eigen::Vector3d::UnitZ()));
}

TEST(DominantDirections, TheFloorIsInTheMiddleOfItsLines) {
  std::mt19937 random(1);
  testing::NormalDistribution<double> noise(0, 0.01);
  double sum = 0;
  constexpr int kNumRooms = 100;
  for (int room = 0; room < kNumRooms; ++room) {
    std::vector<StraightLine> lines;
    for (int i = 0; i < 12; ++i) {
      for (const double height : {0.0, 2.6}) {
        lines.push_back({Eigen::Vector3d::UnitX(), {0, 0, height + noise(random)}, 1});
      }
    }
    const auto floor = FloorHeight(lines, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(floor);
    EXPECT_NEAR(*floor, 0, 0.015);
    sum += *floor;
  }
  EXPECT_NEAR(sum / kNumRooms, 0, 0.0015);
}

}  // namespace
}  // namespace limn
