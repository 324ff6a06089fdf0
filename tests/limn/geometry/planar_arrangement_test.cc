// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/planar_arrangement.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr double kTolerance = 1e-3;

Polyline2d Ring(const Eigen::Vector2d& center, double radius, int sides) {
  Polyline2d ring;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * M_PI * (i % sides) / sides;
    ring.push_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

std::vector<ArrangementCell> CellsBetween(const std::vector<Polyline2d>& strokes) {
  const PlanarArrangement arrangement = Arrange(strokes, kTolerance);
  return FindCells(arrangement, std::vector<uint8_t>(arrangement.edges.size(), 1));
}

std::vector<double> AreasOf(const std::vector<ArrangementCell>& cells) {
  std::vector<double> areas;
  for (const ArrangementCell& cell : cells) areas.push_back(cell.polygon.Area());
  std::ranges::sort(areas);
  return areas;
}

TEST(PlanarArrangement, CrossingLinesSurroundCells) {
  // Two lines each way, beyond their crossings, make one cell; a third one two.
  std::vector<Polyline2d> strokes = {
      {{-1, 0}, {4, 0}}, {{4, 2}, {-1, 2}}, {{0, -1}, {0, 3}}, {{3, -1}, {3, 3}}};
  EXPECT_EQ(AreasOf(CellsBetween(strokes)), std::vector<double>{6});
  strokes.push_back({{1, -1}, {1, 3}});
  EXPECT_EQ(AreasOf(CellsBetween(strokes)), (std::vector<double>{2, 4}));
}

TEST(PlanarArrangement, WhatBoundsNothingIsLeftOut) {
  // A square with a line that ends inside, a tail, and a ring that hangs on it by another line.
  const std::vector<Polyline2d> strokes = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}},
                                           {{0, 2}, {1, 2}},
                                           {{4, 4}, {6, 6}},
                                           {{4, 1}, {8, 1}},
                                           Ring({9, 1}, 1, 4)};
  const std::vector<ArrangementCell> cells = CellsBetween(strokes);
  ASSERT_EQ(cells.size(), 2u);
  for (const ArrangementCell& cell : cells) EXPECT_EQ(cell.loops.size(), 1u);
  EXPECT_NEAR(AreasOf(cells)[0], 2, 1e-12);
  EXPECT_NEAR(AreasOf(cells)[1], 16, 1e-12);
}

TEST(PlanarArrangement, HolesAreOfTheSmallestCellAround) {
  const std::vector<Polyline2d> strokes = {Ring({0, 0}, 10, 4), Ring({0, 0}, 5, 4),
                                           Ring({1, 0}, 1, 4), Ring({-1, 0.5}, 0.5, 4)};
  const std::vector<ArrangementCell> cells = CellsBetween(strokes);
  ASSERT_EQ(cells.size(), 4u);
  for (const ArrangementCell& cell : cells) {
    const double border = SignedArea(cell.polygon.outlines[0]);
    EXPECT_GT(border, 0);
    EXPECT_EQ(cell.loops.size(), border > 150 ? 2u : border > 10 ? 3u : 1u);
    for (size_t h = 1; h < cell.loops.size(); ++h) {
      EXPECT_LT(SignedArea(cell.polygon.outlines[h]), 0);
    }
  }
  EXPECT_NEAR(AreasOf(cells)[3], 200 - 50, 1e-9);
  EXPECT_NEAR(AreasOf(cells)[2], 50 - 2 - 0.5, 1e-9);
}

TEST(PlanarArrangement, TouchingEndsAndSmallGapsAreClosed) {
  // The second line begins within the tolerance of the first one's inside.
  const std::vector<Polyline2d> strokes = {{{0, 0}, {3, 0}},
                                           {{1, 0.5 * kTolerance}, {1, 1}, {2, 1}, {2, 0}}};
  EXPECT_NEAR(AreasOf(CellsBetween(strokes)).at(0), 1, 2 * kTolerance);
  EXPECT_TRUE(CellsBetween({strokes[0], {{1, 3 * kTolerance}, {1, 1}, {2, 1}, {2, 0}}}).empty());
}

TEST(PlanarArrangement, RunsTellWhereStrokesBoundACell) {
  const std::vector<Polyline2d> strokes = {
      {{-1, 0}, {0, 0}, {1, 0}, {2, 0}, {4, 0}}, {{0.5, -1}, {0.5, 1}, {2, 1}}, {{2, 1}, {2, -2}}};
  const PlanarArrangement arrangement = Arrange(strokes, kTolerance);
  const auto cells = FindCells(arrangement, std::vector<uint8_t>(arrangement.edges.size(), 1));
  ASSERT_EQ(cells.size(), 1u);
  std::vector<StrokeRun> runs = RunsAlong(arrangement, cells[0].loops[0]);
  std::ranges::sort(runs, {}, &StrokeRun::stroke);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_NEAR(runs[0].from, 1.5, 1e-12);
  EXPECT_NEAR(runs[0].to, 3, 1e-12);
  EXPECT_NEAR(runs[1].from, 2, 1e-12);
  EXPECT_NEAR(runs[1].to, 0.5, 1e-12);
  EXPECT_NEAR(runs[2].from, 1.0 / 3, 1e-12);
  EXPECT_NEAR(runs[2].to, 0, 1e-12);
}

TEST(PlanarArrangement, UnusedEdgesMergeCells) {
  std::vector<Polyline2d> strokes = {Ring({0, 0}, 1, 4), {{-1, 0}, {1, 0}}};
  const PlanarArrangement arrangement = Arrange(strokes, kTolerance);
  std::vector<uint8_t> use_edge(arrangement.edges.size(), 1);
  EXPECT_EQ(FindCells(arrangement, use_edge).size(), 2u);
  for (size_t e = 0; e < use_edge.size(); ++e) {
    if (arrangement.edges[e].run.stroke == 1) use_edge[e] = 0;
  }
  const auto merged = FindCells(arrangement, use_edge);
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_NEAR(merged[0].polygon.Area(), 2, 1e-12);
}

// Euler's formula for arrangements of random chords of a circle: one component, so the number of
// cells is edges - vertices + 1; together they have the area of the circle's polygon.
TEST(PlanarArrangement, RandomChordsFillTheirCircle) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> corner(0, 359);
  for (int round = 0; round < 20; ++round) {
    const Polyline2d ring = Ring({0, 0}, 100, 360);
    std::vector<Polyline2d> strokes = {ring};
    for (int i = 0; i < 30; ++i) {
      const int from = corner(random), to = corner(random);
      if (from != to) strokes.push_back({ring[from], ring[to]});
    }
    const PlanarArrangement arrangement = Arrange(strokes, 1e-6);
    const auto cells = FindCells(arrangement, std::vector<uint8_t>(arrangement.edges.size(), 1));
    EXPECT_EQ(cells.size(), arrangement.edges.size() - arrangement.vertices.size() + 1);
    double sum = 0;
    for (const ArrangementCell& cell : cells) sum += cell.polygon.Area();
    EXPECT_NEAR(sum, SignedArea({ring.begin(), ring.end() - 1}), 1e-6);
  }
}

}  // namespace
}  // namespace limn
