// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/match_links.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/editing/edited_plane.h"

namespace limn {
namespace {

using testing::DenseLine;
using testing::DenseRing;
using testing::EditViews;
using ::testing::ElementsAre;
using testing::GraphOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RefTo;
using testing::RefToLine;

LinkMatch MatchIn(const DrawingGraph& graph, const LinkRef& ref) {
  return LinkMatcher(graph, EditViews()).Match(ref);
}

TEST(MatchLinks, FindsALinkThatMovedBySomePixelsWhateverItsId) {
  const DrawingGraph graph =
      GraphOf({DenseLine(0, 0, 100, 0), DenseLine(0, 20, 100, 20), DenseLine(0, 0, 0, 20)});
  const LinkMatch match = MatchIn(graph, RefToLine(2, 18.5, 97, 19, 0));
  EXPECT_THAT(match.along, ElementsAre(1));
  EXPECT_THAT(match.longer, IsEmpty());
  EXPECT_EQ(match.Single(), 1);
  EXPECT_DOUBLE_EQ(match.covered, 1);
}

TEST(MatchLinks, IsNotFoundFourPixelsAwayOrAcross) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0)});
  EXPECT_THAT(MatchIn(graph, RefToLine(0, 4, 100, 4)).along, IsEmpty());
  const LinkMatch across = MatchIn(graph, RefToLine(50, -50, 50, 50));
  EXPECT_THAT(across.along, IsEmpty());
  EXPECT_THAT(across.longer, IsEmpty());
  EXPECT_THAT(across.Problem(), HasSubstr("no link runs along it"));
}

TEST(MatchLinks, FindsAllPiecesButNotWhatGoesOnMuchFarther) {
  const DrawingGraph graph =
      GraphOf({DenseLine(0, 0, 40, 0), DenseLine(40, 0, 90, 0), DenseLine(0, 50, 300, 50)});
  const LinkMatch pieces = MatchIn(graph, RefToLine(0, 0.3, 90, 0.3, 1));
  EXPECT_THAT(pieces.along, ElementsAre(0, 1));
  EXPECT_GT(pieces.covered, 0.97);
  EXPECT_EQ(pieces.Single(), std::nullopt);
  EXPECT_THAT(pieces.Problem(), HasSubstr("in pieces"));
  const LinkMatch longer = MatchIn(graph, RefToLine(10, 50, 110, 50, 2));
  EXPECT_THAT(longer.along, IsEmpty());
  EXPECT_THAT(longer.longer, ElementsAre(2));
  EXPECT_THAT(longer.Problem(), HasSubstr("extends much farther"));
}

TEST(MatchLinks, CoversLessWhereAPieceIsMissing) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 30, 0)});
  const LinkMatch match = MatchIn(graph, RefToLine(0, 0, 100, 0));
  EXPECT_THAT(match.along, ElementsAre(0));
  EXPECT_NEAR(match.covered, 0.32, 0.03);
}

TEST(MatchLinks, TheNearestOfTwoSideBySideIsMeant) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0), DenseLine(0, 2, 100, 2)});
  EXPECT_EQ(MatchIn(graph, RefToLine(0, 0.2, 100, 0.2, 1)).Single(), 0);
  EXPECT_EQ(MatchIn(graph, RefToLine(0, 1.9, 100, 1.9, 0)).Single(), 1);
}

TEST(MatchLinks, OfEquallyNearOnesTheIdDecides) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0), DenseLine(0, 0.4, 100, 0.4)});
  EXPECT_EQ(MatchIn(graph, RefToLine(0, 0.1, 100, 0.1, 1)).Single(), 1);
  EXPECT_EQ(MatchIn(graph, RefToLine(0, 0.3, 100, 0.3, 0)).Single(), 0);
  const LinkMatch unknown = MatchIn(graph, RefToLine(0, 0.1, 100, 0.1));
  EXPECT_TRUE(unknown.IsAmbiguous());
  EXPECT_EQ(unknown.Single(), std::nullopt);
  EXPECT_THAT(unknown.Problem(), HasSubstr("links 0, 1 are equally near"));
}

// The chords of 15 parts of the circle are up to 4.4 px inside it.
TEST(MatchLinks, FollowsCurvesBetweenThePointsOfAReference) {
  const DrawingGraph graph =
      GraphOf({testing::InWorld(testing::RingThroughOrigin(200)), DenseRing(0, 200, 194)});
  const LinkMatch match = MatchIn(graph, RefTo(graph.links[0].points_in_world));
  EXPECT_THAT(match.along, ElementsAre(0));
  EXPECT_DOUBLE_EQ(match.covered, 1);
}

TEST(MatchLinks, KnowsOfChangesAfterUpdates) {
  DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0), DenseLine(0, 50, 100, 50)});
  LinkMatcher matcher(graph, EditViews());
  for (Eigen::Vector3d& point : graph.links[0].points_in_world) point.y() += 0.3;
  matcher.Update(0);
  EXPECT_THAT(matcher.Match(RefToLine(0, 0, 100, 0)).along, IsEmpty());
  EXPECT_THAT(
      matcher.Match(RefToLine(0, 0.3 / testing::kFrontalPx, 100, 0.3 / testing::kFrontalPx)).along,
      ElementsAre(0));
  testing::DrawLink(DenseLine(0, -50, 100, -50), {}, &graph);
  matcher.Update(2);
  EXPECT_THAT(matcher.Match(RefToLine(0, -50, 100, -50)).along, ElementsAre(2));
  graph.links[1].node0 = -1;  // as GraphEditor::Remove does
  matcher.Update(1);
  EXPECT_THAT(matcher.Match(RefToLine(0, 50, 100, 50)).along, IsEmpty());
}

TEST(MatchLinks, AnEmptyDrawingHasNoLinks) {
  EXPECT_THAT(MatchIn({}, RefToLine(0, 0, 100, 0)).along, IsEmpty());
}

}  // namespace
}  // namespace limn
