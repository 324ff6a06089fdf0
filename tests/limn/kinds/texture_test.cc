// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/texture.h"

#include <numbers>

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::FrontalPoint;
using testing::FrontalViews;

constexpr int kSide = 5;  // sticks of a field

// Links in the plane that all views face, in px.
class TextureTest : public ::testing::Test {
 protected:
  LinkId Draw(const std::vector<Eigen::Vector2d>& px) {
    Polyline3d points;
    for (const Eigen::Vector2d& place : px) points.push_back(FrontalPoint(place.x(), place.y()));
    return DrawLink(points, {0, 1}, &graph_);
  }

  // Sticks of 10 px, 20 px apart, from a corner on.
  void DrawField(double x, double y) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const Eigen::Vector2d from(x + 20 * (i % kSide), y + 20 * (i / kSide));
      Draw({from, from + Eigen::Vector2d(10, 0)});
    }
  }

  void DrawCircle(double x, double y, double radius) {
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k <= 16; ++k) {
      const double angle = 2 * std::numbers::pi * (k % 16) / 16;
      points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    Draw(points);
  }

  // An H of 30 px: all its strokes are short, and four of its ends are free.
  void DrawSign(double x, double y) {
    for (const double side : {0.0, 20.0}) {
      Draw({{x + side, y}, {x + side, y + 15}});
      Draw({{x + side, y + 15}, {x + side, y + 30}});
    }
    Draw({{x, y + 15}, {x + 20, y + 15}});
  }

  // Whether each link is texture.
  std::vector<bool> Marked() {
    MeasureCurves(views_, &graph_);
    MarkTexture(views_, &graph_);
    testing::ExpectValid(graph_);
    std::vector<bool> marked;
    for (const DrawingLink& link : graph_.links) marked.push_back(link.kind == LinkKind::kTexture);
    return marked;
  }

  std::vector<View> views_ = FrontalViews(2, 1, 0.1);
  DrawingGraph graph_;
};

TEST_F(TextureTest, AFieldOfShortSticksIs) {
  DrawField(0, 0);
  EXPECT_EQ(Marked(), std::vector<bool>(kSide * kSide, true));
  for (const DrawingLink& link : graph_.links) EXPECT_EQ(link.kind_confidence, 1);
}

TEST_F(TextureTest, SummaryCountsEveryLinkOnce) {
  DrawField(0, 0);
  Draw({{-200, 0}, {-200, 100}});
  MeasureCurves(views_, &graph_);
  const StageSummary summary = MarkTexture(views_, &graph_);
  EXPECT_EQ(summary.in, (StageSummary::Counts{{"links", 26}}));
  EXPECT_EQ(summary.kept, (StageSummary::Counts{{"links: texture", 25}, {"links: others", 1}}));
}

TEST_F(TextureTest, ShortEdgesAmongLongOnesAreNot) {
  for (int i = 0; i < 10; ++i) {
    Draw({{0, 12.0 * i}, {100, 12.0 * i}});
    Draw({{40, 12.0 * i + 4}, {55, 12.0 * i + 4}});
  }
  EXPECT_EQ(Marked(), std::vector<bool>(20, false));
}

TEST_F(TextureTest, WhereLongCurvesAreNothingIs) {
  DrawField(0, 0);
  const LinkId line = Draw({{0, 35}, {76, 35}});
  std::vector<bool> expected(kSide * kSide + 1, false);
  // The rest is short for three quarters only.
  EXPECT_EQ(Marked(), expected);
  graph_.links[line].points_in_world[1] = FrontalPoint(60, 35);
  graph_.nodes[graph_.links[line].node1].position_in_world = FrontalPoint(60, 35);
  expected.assign(expected.size(), true);
  EXPECT_EQ(Marked(), expected);
}

TEST_F(TextureTest, APieceOfALongCurveIsNot) {
  DrawField(0, 0);
  for (int i = 0; i < 4; ++i) DrawField(100 * i, 100);
  const LinkId first = Draw({{-35, 35}, {35, 35}});
  const LinkId piece = Draw({{35, 35}, {45, 35}});
  EXPECT_TRUE(Marked()[piece]);
  for (DrawingLink& link : graph_.links) link.kind = LinkKind::kUnknown;
  graph_.nodes[graph_.links[piece].node0].continuations = {{{first, 1}, {piece, 0}}};
  EXPECT_FALSE(Marked()[piece]);
}

TEST_F(TextureTest, SmallCirclesAreNot) {
  DrawField(0, 0);
  DrawCircle(45, 36, 4);
  EXPECT_FALSE(Marked().back());
}

TEST_F(TextureTest, ASignByItselfIsNotButManyAre) {
  DrawSign(0, 0);
  EXPECT_EQ(Marked(), std::vector<bool>(5, false));
  for (int k = 1; k < 12; ++k) DrawSign(26 * (k % 4), 26 * (k / 4));
  EXPECT_EQ(Marked(), std::vector<bool>(60, true));
}

TEST_F(TextureTest, DoubtedLinksContoursAndRodsAreNot) {
  DrawField(0, 0);
  graph_.links[6].tentative = true;
  graph_.links[7].kind = LinkKind::kContour;
  graph_.links[8].kind = LinkKind::kRod;
  graph_.links[8].rod_radius = 0.01;
  graph_.links[8].kind_confidence = 1;
  const std::vector<bool> marked = Marked();
  for (size_t l = 0; l < marked.size(); ++l) EXPECT_EQ(marked[l], l < 6 || l > 8) << l;
}

TEST_F(TextureTest, DoubtedLinksMakeNone) {
  DrawField(0, 0);
  for (size_t l = 1; l < graph_.links.size(); ++l) graph_.links[l].tentative = true;
  EXPECT_FALSE(Marked()[0]);
}

TEST_F(TextureTest, CurvesAreMeasuredInPixelsAcrossTheirLinks) {
  Draw({{0, 0}, {30, 0}});
  Draw({{30, 0}, {50, 0}});
  Draw({{50, 0}, {60, 0}});
  Draw({{30, 0}, {30, 15}});
  graph_.nodes[1].continuations = {{{0, 1}, {1, 0}}};
  graph_.nodes[2].continuations = {{{1, 1}, {2, 0}}};
  graph_.links[2].tentative = true;
  MeasureCurves(views_, &graph_);
  for (const auto& [link, px] : {std::pair(0, 50.0), {1, 50.0}, {2, 10.0}, {3, 15.0}}) {
    EXPECT_NEAR(graph_.links[link].curve_px, px, 1e-6) << link;
  }
}

}  // namespace
}  // namespace limn
