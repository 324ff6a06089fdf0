// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/plan_line.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Eigen::Vector3d kPlanUp = Eigen::Vector3d::UnitZ();

// The angle of the plan's x in the drawing, degrees.
double XOf(const DrawingGraph& graph, const std::vector<std::string>& texts,
           const Eigen::Vector3d& hint = Eigen::Vector3d::UnitX()) {
  const Eigen::Vector3d x = FitPlanLines(graph, ParsePlanLines(texts), kPlanUp, hint);
  EXPECT_NEAR(x.norm(), 1, 1e-12);
  EXPECT_NEAR(x.z(), 0, 1e-12);
  return Degrees(std::atan2(x.y(), x.x()));
}

TEST(PlanLine, IsADirectionOfALinkOrBetweenPlaces) {
  const auto lines =
      ParsePlanLines({"link 12 = 30 deg", "from 3 to 7=-y", "a.jpg 1,2 to b.jpg 3,4 = north"});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NEAR(lines[0].angle_rad, 30 * kDeg, 1e-12);
  EXPECT_EQ(lines[1].span.node1, 7);
  EXPECT_NEAR(lines[1].angle_rad, 270 * kDeg, 1e-12);
  EXPECT_EQ(lines[2].span.pixels.size(), 2u);
  EXPECT_NEAR(lines[2].angle_rad, 90 * kDeg, 1e-12);
}

TEST(PlanLine, OtherTextsAreRefused) {
  for (const char* text : {"", "link 12", "link 12 = ", "link 12 = 30", "link 12 = z",
                           "link 12 = 400 deg", "link 12 = nan deg", "link -1 = x", "= x"}) {
    EXPECT_THAT([&] { ParsePlanLines({text}); },
                ThrowsMessage<OptionError>(HasSubstr("plan_line = " + std::string(text) + ": ")))
        << text;
  }
}

// Link 0 and nodes 0, 1 of the room are along x.
TEST(PlanLine, TurnsThePlan) {
  const DrawingGraph graph = testing::WireRoom();
  EXPECT_NEAR(XOf(graph, {"from 0 to 1 = x"}), 0, 1e-9);
  EXPECT_NEAR(XOf(graph, {"from 0 to 1 = y"}), -90, 1e-9);
  EXPECT_NEAR(std::abs(XOf(graph, {"from 1 to 0 = x"})), 180, 1e-9);
  EXPECT_NEAR(XOf(graph, {"from 0 to 1 = 30 deg"}), -30, 1e-9);
}

TEST(PlanLine, ALinkMayRunEitherWay) {
  DrawingGraph graph = testing::WireRoom();
  EXPECT_NEAR(XOf(graph, {"link 0 = 180 deg"}), 0, 1e-9);
  EXPECT_NEAR(std::abs(XOf(graph, {"link 0 = x"}, -Eigen::Vector3d::UnitX())), 180, 1e-9);
  // The places tell which.
  EXPECT_NEAR(std::abs(XOf(graph, {"link 0 = x", "from 1 to 0 = x"})), 180, 1e-9);
  // At right angles to the hint each is on one side of it or the other by chance.
  graph.nodes[graph.links[0].node1].position_in_world.y() += 0.02;
  graph.links[0].primitive.reset();
  EXPECT_NEAR(std::abs(XOf(graph, {"link 0 = y", "link 1 = y"})), 90, 1);
  EXPECT_NEAR(std::abs(XOf(graph, {"link 1 = y", "link 0 = y"})), 90, 1);
}

TEST(PlanLine, WhatDoesNotFitIsNamed) {
  const DrawingGraph graph = testing::WireRoom();
  EXPECT_THAT(
      [&] {
        XOf(graph, {"link 0 = x", "link 4 = 20 deg"});
      },
      ThrowsMessage<OptionError>(HasSubstr("plan_line = link 0 = x: contradicts \"link 4 "
                                           "= 20 deg\": x differs by 70 degrees")));
  EXPECT_THAT([&] { XOf(graph, {"link 8 = x"}); },
              ThrowsMessage<OptionError>(HasSubstr("is upright")));
  EXPECT_THAT([&] { XOf(graph, {"link 99 = x"}); },
              ThrowsMessage<OptionError>(HasSubstr("the drawing has no link 99")));
}

}  // namespace
}  // namespace limn
