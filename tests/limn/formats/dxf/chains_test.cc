// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/chains.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/picture_scene.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

CircularArc HalfCircle(const Eigen::Vector3d& center, bool clockwise) {
  CircularArc arc;
  arc.center = center;
  arc.sweep_rad = std::numbers::pi;
  if (clockwise) arc.y_axis = -arc.y_axis;
  return arc;
}

class ChainsTest : public ::testing::Test {
 protected:
  void Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    AddLink({from, to}, LineSegment{from, to}, &flat_.graph);
  }
  // Its ends, at whole numbers, without what sines leave.
  void Arc(const CircularArc& arc) {
    Polyline3d points = SampleShape(arc, 1e-4);
    for (Eigen::Vector3d* end : {&points.front(), &points.back()}) *end = end->array().round();
    AddLink(points, arc, &flat_.graph);
  }

  std::vector<FlatChain> Find(double tolerance = 1e-3) {
    RebuildIncidence(&flat_.graph);
    flat_.ellipses.resize(flat_.graph.links.size());
    layers_.resize(flat_.graph.links.size(), 0);
    return FindChains(flat_, layers_, tolerance);
  }

  FlatLinks flat_;
  std::vector<int> layers_;
};

TEST_F(ChainsTest, LinesThatMeetAreOne) {
  Line({0, 0, 0}, {1, 0, 0});
  Line({1, 1, 0}, {1, 0, 0});
  const auto chains = Find();
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_THAT(chains[0].links, ElementsAre(0, 1));
  EXPECT_FALSE(chains[0].closed);
  ASSERT_EQ(chains[0].vertices.size(), 3u);
  EXPECT_EQ(chains[0].vertices[1].place, Eigen::Vector2d(1, 0));
  EXPECT_EQ(chains[0].vertices[2].place, Eigen::Vector2d(1, 1));
}

TEST_F(ChainsTest, NotOfTwoLayers) {
  Line({0, 0, 0}, {1, 0, 0});
  Line({1, 0, 0}, {1, 1, 0});
  layers_ = {0, 1};
  EXPECT_EQ(Find().size(), 2u);
}

TEST_F(ChainsTest, LinesGoOnThroughJunctionsAsOne) {
  Line({0, 0, 0}, {1, 0, 0});
  Line({1, 0, 0}, {1, 1, 0});
  Line({1, 0, 0}, {2, 0.0005, 0});
  const auto chains = Find();
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_THAT(chains[0].links, ElementsAre(0, 2));
  EXPECT_EQ(chains[0].vertices.size(), 2u);
  EXPECT_EQ(Find(/*tolerance=*/1e-5)[0].vertices.size(), 3u);
}

// In whichever order.
TEST_F(ChainsTest, ALineAndAnArcAreAClosedChain) {
  const Eigen::Vector3d left(-1, 0, 0), right(1, 0, 0);
  for (const bool line_first : {true, false}) {
    SCOPED_TRACE(line_first);
    flat_ = {};
    layers_.clear();
    if (line_first) Line(left, right);
    Arc(HalfCircle({0, 0, 0}, /*clockwise=*/false));
    if (!line_first) Line(left, right);
    const auto chains = Find();
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_TRUE(chains[0].closed);
    ASSERT_EQ(chains[0].vertices.size(), 2u);
    double bulge = 0;
    for (const ChainVertex& vertex : chains[0].vertices) bulge += vertex.bulge;
    EXPECT_NEAR(std::abs(bulge), 1, 1e-9);  // half a turn
  }
}

TEST_F(ChainsTest, ABulgeIsPositiveCounterClockwise) {
  // From (1, 0) to (-1, 0), above and below.
  for (const bool clockwise : {false, true}) {
    flat_ = {};
    layers_.clear();
    Arc(HalfCircle({0, 0, 0}, clockwise));
    Line({-1, 0, 0}, {-2, 0, 0});
    const auto chains = Find();
    ASSERT_EQ(chains.size(), 1u);
    const ChainVertex& first = chains[0].vertices.front();
    const ChainVertex& second = chains[0].vertices[1];
    const bool is_reversed = chains[0].links.front() == 1;
    const double bulge = is_reversed ? second.bulge : first.bulge;
    EXPECT_NEAR(bulge, clockwise == is_reversed ? 1 : -1, 1e-9);
  }
}

TEST_F(ChainsTest, ARectangleIsOneLoop) {
  const Eigen::Vector3d a(0, 0, 0), b(2, 0, 0), c(2, 1, 0), d(0, 1, 0);
  Line(a, b);
  Line(c, b);
  Line(c, d);
  Line(a, d);
  const auto chains = Find();
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[0].vertices.size(), 4u);
  EXPECT_THAT(chains[0].links, UnorderedElementsAre(0, 1, 2, 3));
}

TEST_F(ChainsTest, CirclesAndEllipsesAreInNone) {
  CircularArc circle;
  circle.sweep_rad = 2 * std::numbers::pi;
  Arc(circle);
  Line({5, 0, 0}, {6, 0, 0});
  flat_.ellipses.resize(2);
  flat_.ellipses[1] = EllipticalArc();
  EXPECT_TRUE(Find().empty());
}

}  // namespace
}  // namespace limn
