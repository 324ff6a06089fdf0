// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/editing/edited_plane.h"

namespace limn {
namespace {

using testing::DegreeAt;
using testing::DenseLine;
using testing::DenseRing;
using testing::Edited;
using ::testing::ElementsAre;
using testing::FrontalPoint;
using testing::GraphOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kFrontalPx;
using testing::RefTo;
using testing::RefToLine;
using testing::Refused;
using ::testing::SizeIs;

JoinEnds JoinOf(const LinkRef& a, int end_a, const LinkRef& b, int end_b) {
  return {{EndRef{a, end_a}, EndRef{b, end_b}}};
}

TEST(JoinEdit, FreeEndsThatContinueEachOtherMakeOneLink) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(120, 1, 80, 1)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(120, 1, 80, 1), 1)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_EQ(edited.graph.nodes.size(), 2u);
  EXPECT_EQ(edited.graph.links[0].points_in_world.back(), FrontalPoint(120, 1));
  EXPECT_THAT(edited.touched, ElementsAre(1));
  ASSERT_THAT(edited.gaps, SizeIs(1));
  EXPECT_NEAR(edited.gaps[0].length_px, 20, 0.1);
  EXPECT_EQ(edited.gaps[0].edit, 0u);
}

TEST(JoinEdit, OneThatOvershootsDoesNotRunBack) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(50, 2, 120, 2)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(50, 2, 120, 2), 0)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_LT(testing::SharpestTurn(edited.graph.links[0].points_in_world), M_PI / 2);
}

TEST(JoinEdit, OtherFreeEndsMeetWhereTheirLinesDo) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 94, 0), DenseLine(100, 8, 100, 80)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 94, 0), 1, RefToLine(100, 8, 100, 80), 0)});
  ASSERT_EQ(edited.graph.links.size(), 2u);
  EXPECT_EQ(DegreeAt(edited.graph, FrontalPoint(100, 0), 0.01 * kFrontalPx), 2);
  EXPECT_THAT(edited.touched, ElementsAre(1, 1));
  EXPECT_THAT(edited.graph.nodes[0].continuations, IsEmpty());
}

TEST(JoinEdit, ParallelEndsMeetHalfway) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(0, 8, 60, 8)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(0, 8, 60, 8), 1)});
  EXPECT_EQ(edited.graph.links.size(), 2u);
  EXPECT_EQ(DegreeAt(edited.graph, FrontalPoint(60, 4), 0.01 * kFrontalPx), 2);
}

TEST(JoinEdit, AFreeEndGoesToTheNodeOfOthersWhichStay) {
  const DrawingGraph graph =
      GraphOf({DenseLine(0, 0, 60, 0), DenseLine(60, 0, 120, 0), DenseLine(62, 50, 62, 5)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(62, 50, 62, 5), 1, RefToLine(0, 0, 60, 0), 1)});
  EXPECT_EQ(DegreeAt(edited.graph, FrontalPoint(60, 0)), 3);
  EXPECT_THAT(edited.touched, ElementsAre(0, 0, 1));
  EXPECT_EQ(edited.graph.links[0].points_in_world, graph.links[0].points_in_world);
  // The two lines still continue each other.
  EXPECT_EQ(testing::ContinuationsAt(edited.graph, FrontalPoint(60, 0)).size(), 1u);
}

TEST(JoinEdit, TwoNodesBecomeOneAndTheLinkBetweenThemVanishes) {
  const DrawingGraph graph =
      GraphOf({DenseLine(0, 0, 60, 0), DenseLine(60, 0, 60, -50), DenseLine(66, 0, 120, 0),
               DenseLine(66, 0, 66, 50), DenseLine(60, 0, 66, 0)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(66, 0, 120, 0), 0)});
  ASSERT_EQ(edited.graph.links.size(), 4u);
  EXPECT_EQ(DegreeAt(edited.graph, FrontalPoint(63, 0)), 4);
  EXPECT_THAT(edited.touched, ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(edited.outcomes[0].text, HasSubstr("removed: 1"));
}

TEST(JoinEdit, TwoLinksThatMeetSmoothlyBecomeOne) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(60, 0, 120, 0)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(60, 0, 120, 0), 0)});
  EXPECT_EQ(edited.graph.links.size(), 1u);
}

TEST(JoinEdit, EndsAtOneCornerMakeNoSense) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(60, 0, 60, 50)});
  EXPECT_EQ(Refused(graph, JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(60, 0, 60, 50), 0)).status,
            EditStatus::kNoSense);
}

TEST(JoinEdit, BothEndsOfALinkCloseIt) {
  Polyline3d arc = DenseRing(0, 0, 50);
  arc.resize(arc.size() - 2);
  const DrawingGraph graph = GraphOf({arc});
  const EditedDrawing edited = Edited(graph, {JoinOf(RefTo(arc), 1, RefTo(arc), 0)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_TRUE(edited.graph.links[0].closed);
}

TEST(JoinEdit, EndsOfOneLinkMeetAtACorner) {
  // Their lines meet in the middle of the link, behind both.
  Polyline3d bent = DenseLine(30, 0, 0, 52);
  const Polyline3d other_arm = DenseLine(0, 52, -30, 0);
  bent.insert(bent.end(), other_arm.begin() + 1, other_arm.end());
  const EditedDrawing edited = Edited(GraphOf({bent}), {JoinOf(RefTo(bent), 0, RefTo(bent), 1)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_TRUE(edited.graph.links[0].closed);
  // Only what overshoots the middle between the ends is lost, 15 px of each arm.
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 142 * kFrontalPx, 6 * kFrontalPx);
}

TEST(JoinEdit, ALinkThatEnclosesNothingIsNotClosed) {
  Polyline3d bow = DenseLine(0, 0, 40, 0);
  const Polyline3d other_half = DenseLine(40, 0, 70, 30);
  bow.insert(bow.end(), other_half.begin() + 1, other_half.end());
  const EditOutcome outcome = Refused(GraphOf({bow}), JoinOf(RefTo(bow), 0, RefTo(bow), 1));
  EXPECT_EQ(outcome.status, EditStatus::kNoSense);
  EXPECT_THAT(outcome.text, HasSubstr("too short to be closed"));
}

TEST(JoinEdit, GeometryDecidesWhichEndIsMeant) {
  // The second link is the other way round than when the edit was made.
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(120, 0, 70, 0)});
  const EditedDrawing edited =
      Edited(graph, {JoinOf(RefToLine(0, 0, 60, 0), 1, RefToLine(70, 0, 120, 0, 1), 0)});
  EXPECT_EQ(edited.graph.links.size(), 1u);
}

TEST(JoinEdit, AnEndThatIsElsewhereNowIsNotFound) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(90, 0, 150, 0)});
  const EditOutcome outcome =
      Refused(graph, JoinOf(RefToLine(0, 0, 80, 0), 1, RefToLine(90, 0, 150, 0), 0));
  EXPECT_EQ(outcome.status, EditStatus::kNotFound);
  EXPECT_THAT(outcome.text, HasSubstr("20 px from where it was"));
}

TEST(JoinEdit, AKindSetByHandStays) {
  DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(65, 0, 200, 0)});
  graph.links[1].kind = LinkKind::kEdge;
  graph.links[1].kind_confidence = 1;
  const EditedDrawing edited =
      Edited(graph, {SetLinkKind{{RefToLine(0, 0, 60, 0)}, LinkKind::kShadow},
                     JoinOf(RefToLine(65, 0, 200, 0), 0, RefToLine(0, 0, 60, 0), 1)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_EQ(edited.graph.links[0].kind, LinkKind::kShadow);
  EXPECT_THAT(edited.kind_by_hand, ElementsAre(1));
}

}  // namespace
}  // namespace limn
