// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/known_lengths.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(KnownLengths, AreOfLinksAndBetweenNodes) {
  const auto lengths = ParseKnownLengths({"link 12 = 2.40 m", "from 3 to 7=8ft", "link 0=35 mm",
                                          "link  1  =  1.5e2  cm", "link 2 = 10 in"});
  ASSERT_EQ(lengths.size(), 5u);
  EXPECT_EQ(lengths[0].span.link, 12);
  EXPECT_DOUBLE_EQ(lengths[0].meters, 2.4);
  EXPECT_EQ(lengths[1].span.link, -1);
  EXPECT_EQ(lengths[1].span.node0, 3);
  EXPECT_EQ(lengths[1].span.node1, 7);
  EXPECT_DOUBLE_EQ(lengths[1].meters, 8 * 0.3048);
  EXPECT_DOUBLE_EQ(lengths[2].meters, 0.035);
  EXPECT_DOUBLE_EQ(lengths[3].meters, 1.5);
  EXPECT_DOUBLE_EQ(lengths[4].meters, 0.254);
}

TEST(KnownLengths, OtherTextsAreRefused) {
  for (const char* text :
       {"", "link 12", "link 12 = 2.40", "link -1 = 2 m", "link 1 = 2 km", "link 1 = m",
        "link 1 = 0 m", "link 1 = -2 m", "link 1 = 1e300 m", "link 1 = 1..2 m", "from 1 = 2 m",
        "from 1 to = 2 m", "link 99999999999 = 2 m", "link 1 = nan m"}) {
    EXPECT_THAT([&] { ParseKnownLengths({text}); },
                ThrowsMessage<OptionError>(HasSubstr("known_length = " + std::string(text) + ": ")))
        << text;
  }
  EXPECT_THROW(ParseKnownLengths({std::string(1000000, '1')}), OptionError);
}

TEST(KnownLengths, SeveralAreFittedByLeastSquares) {
  const DrawingGraph graph = testing::WireRoom();  // link 0: 5, link 4: 4
  const LengthFit one = FitLengths(graph, ParseKnownLengths({"link 0 = 10 m"}));
  EXPECT_DOUBLE_EQ(one.scale, 2);
  EXPECT_DOUBLE_EQ(one.lengths[0], 10);
  const LengthFit two = FitLengths(graph, ParseKnownLengths({"link 0 = 10 m", "link 4 = 8.2 m"}));
  EXPECT_DOUBLE_EQ(two.scale, (5 * 10 + 4 * 8.2) / 41.0);
  EXPECT_DOUBLE_EQ(two.lengths[1], 4 * two.scale);
  EXPECT_DOUBLE_EQ(FitLengths(graph, ParseKnownLengths({"from 0 to 1 = 2.5 m"})).scale, 0.5);
}

// As of all nodes.
DrawingGraph WireRoomWithin(double sigma) {
  DrawingGraph graph = testing::WireRoom();
  for (DrawingNode& node : graph.nodes) {
    node.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
  }
  return graph;
}

TEST(KnownLengths, TellTheErrorOfTheScale) {
  const DrawingGraph graph = testing::WireRoom();
  EXPECT_EQ(FitLengths(graph, ParseKnownLengths({"link 0 = 10 m"})).sigma, 0);
  const LengthFit same = FitLengths(graph, ParseKnownLengths({"link 0 = 10 m", "link 4 = 8 m"}));
  EXPECT_NEAR(same.sigma, 0, 1e-12);
  const LengthFit apart = FitLengths(graph, ParseKnownLengths({"link 0 = 10 m", "link 4 = 8.2 m"}));
  EXPECT_NEAR(apart.sigma, 0.0123, 0.001);  // half of the difference
  // Of 5, between two places.
  const LengthFit within = FitLengths(WireRoomWithin(0.1), ParseKnownLengths({"link 0 = 10 m"}));
  EXPECT_NEAR(within.sigma, 0.1 * std::sqrt(2) / 5, 1e-12);
}

TEST(KnownLengths, ThatContradictEachOtherAreNamed) {
  const DrawingGraph graph = testing::WireRoom();
  const auto fit = [&](const std::vector<std::string>& texts) {
    return FitLengths(graph, ParseKnownLengths(texts));
  };
  EXPECT_THAT(
      [&] {
        fit({"link 0 = 10 m", "link 4 = 9 m"});
      },
      ThrowsMessage<OptionError>(
          "known_length = link 0 = 10 m: contradicts \"link 4 = 9 m\": a unit of the drawing "
          "is 2 m by the one and 2.25 m by the other, 12.5 % apart; measure both again, or "
          "leave one out"));
  EXPECT_THROW(fit({"link 0 = 10 m", "link 0 = 12 m"}), OptionError);
  // The other two agree with one of them.
  EXPECT_THAT(
      [&] {
        fit({"link 1 = 10 m", "link 0 = 10.1 m", "link 4 = 16 m", "link 2 = 10 m"});
      },
      ThrowsMessage<OptionError>(
          ::testing::AllOf(HasSubstr("contradicts \"link 4 = 16 m\""),
                           HasSubstr("(2 of the others agree with \"link 1 = 10 m\")"))));
}

TEST(KnownLengths, OfUncertainLinksMayDiffer) {
  const DrawingGraph graph = WireRoomWithin(0.2);
  EXPECT_GT(FitLengths(graph, ParseKnownLengths({"link 0 = 10 m", "link 4 = 9 m"})).sigma, 0.03);
  EXPECT_THROW(FitLengths(graph, ParseKnownLengths({"link 0 = 10 m", "link 4 = 20 m"})),
               OptionError);
}

TEST(KnownLengths, OfALinkAreThoseOfItsPrimitive) {
  DrawingGraph graph = testing::WireRoom();
  graph.links[0].points_in_world[1].z() += 0.5;
  const auto known = ParseKnownLengths({"link 0 = 5 m"});
  EXPECT_DOUBLE_EQ(FitLengths(graph, known).scale, 1);
  CircularArc arc;
  arc.radius = 2.5;
  arc.sweep_rad = 1;
  graph.links[0].primitive->shape = arc;
  EXPECT_DOUBLE_EQ(FitLengths(graph, known).scale, 2);
  graph.links[0].primitive.reset();
  EXPECT_LT(FitLengths(graph, known).scale, 0.99);
}

TEST(KnownLengths, ThatTheDrawingDoesNotHaveAreNamed) {
  const DrawingGraph graph = testing::WireRoom();
  const auto fails = [&](const std::string& text, const std::string& reason) {
    EXPECT_THAT([&] { FitLengths(graph, ParseKnownLengths({text})); },
                ThrowsMessage<OptionError>("known_length = " + text + ": " + reason));
  };
  fails("link 38 = 1 m", "the drawing has no link 38, only 38");
  fails("from 0 to 500 = 1 m", "the drawing has no node 500, only 76");
  fails("from 3 to 3 = 1 m", "both places are the same");
}

}  // namespace
}  // namespace limn
