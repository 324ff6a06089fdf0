// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/apply_edits.h"

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

// Two lines end to end, and a third one apart.
DrawingGraph ThreeLines() {
  return GraphOf({DenseLine(0, 0, 60, 0), DenseLine(60, 0, 120, 0), DenseLine(0, 40, 120, 40)});
}

TEST(ApplyEdits, WithoutEditsNothingChanges) {
  const DrawingGraph graph = ThreeLines();
  const EditedDrawing edited = Edited(graph, {});
  ASSERT_EQ(edited.graph.links.size(), 3u);
  for (int l = 0; l < 3; ++l) {
    EXPECT_EQ(edited.graph.links[l].points_in_world, graph.links[l].points_in_world);
  }
  EXPECT_THAT(edited.touched, ElementsAre(0, 0, 0));
}

TEST(ApplyEdits, DeletesAllPieces) {
  const EditedDrawing edited = Edited(ThreeLines(), {DeleteLinks{{RefToLine(0, 0, 120, 0)}}});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_EQ(edited.graph.links[0].points_in_world[0], FrontalPoint(0, 40));
  EXPECT_EQ(edited.outcomes[0].status, EditStatus::kApplied);
  EXPECT_EQ(edited.outcomes[0].text, "2 links deleted");
  EXPECT_THAT(edited.touched, ElementsAre(0));
}

TEST(ApplyEdits, AReferenceThatIsGoneIsToldAndTheOthersAreDeleted) {
  const EditedDrawing edited =
      Edited(ThreeLines(), {DeleteLinks{{RefToLine(0, 40, 120, 40), RefToLine(0, 80, 120, 80)}}});
  EXPECT_EQ(edited.graph.links.size(), 2u);
  EXPECT_EQ(edited.outcomes[0].status, EditStatus::kPartly);
  EXPECT_EQ(edited.outcomes[0].text, "1 link deleted, but of 1 of 2 links: no link runs along it");
}

TEST(ApplyEdits, OfAReferenceMostOfWhichIsGoneTheRestIsDeleted) {
  const EditedDrawing edited = Edited(ThreeLines(), {DeleteLinks{{RefToLine(0, 40, 400, 40)}}});
  EXPECT_EQ(edited.graph.links.size(), 2u);
  EXPECT_EQ(edited.outcomes[0].status, EditStatus::kPartly);
  EXPECT_THAT(edited.outcomes[0].text, HasSubstr("% of it is left"));
}

TEST(ApplyEdits, ALinkThatGoesOnMuchFartherIsNotDeleted) {
  const EditOutcome outcome = Refused(ThreeLines(), DeleteLinks{{RefToLine(0, 40, 50, 40)}});
  EXPECT_EQ(outcome.status, EditStatus::kNotFound);
  EXPECT_EQ(outcome.text, "link 2 runs along it, but extends much farther");
}

TEST(ApplyEdits, TwinsAreAmbiguous) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 60, 0), DenseLine(0, 0.2, 60, 0.2)});
  EXPECT_EQ(Refused(graph, DeleteLinks{{RefToLine(0, 0.1, 60, 0.1)}}).status,
            EditStatus::kAmbiguous);
}

TEST(ApplyEdits, TentativeLinksBecomeFirm) {
  DrawingGraph graph = ThreeLines();
  graph.links[2].tentative = true;
  graph.links[2].doubt = LinkDoubt::kChance;
  const EditedDrawing edited = Edited(graph, {RestoreLinks{{RefToLine(0, 40, 120, 40)}}});
  EXPECT_FALSE(edited.graph.links[2].tentative);
  EXPECT_EQ(edited.graph.links[2].doubt, LinkDoubt::kNone);
  EXPECT_THAT(edited.touched, ElementsAre(0, 0, 0));
}

TEST(ApplyEdits, KindsAreSetByHand) {
  const EditedDrawing edited =
      Edited(ThreeLines(), {SetLinkKind{{RefToLine(0, 0, 120, 0)}, LinkKind::kPaint},
                            SetLinkKind{{RefToLine(0, 40, 120, 40)}, LinkKind::kUnknown}});
  EXPECT_EQ(edited.graph.links[1].kind, LinkKind::kPaint);
  EXPECT_EQ(edited.graph.links[1].kind_confidence, 1);
  EXPECT_EQ(edited.graph.links[2].kind_confidence, 0);
  EXPECT_THAT(edited.kind_by_hand, ElementsAre(1, 1, 1));
  EXPECT_THAT(edited.touched, ElementsAre(0, 0, 0));
}

TEST(ApplyEdits, SplitsAtThePlaceAndTheHalvesGoOnIntoEachOther) {
  const Eigen::Vector3d place = FrontalPoint(50.3, 40);
  const EditedDrawing edited =
      Edited(ThreeLines(), {SplitLink{{RefToLine(0, 40, 120, 40), FrontalPoint(50.3, 41)}},
                            SetLinkKind{{RefToLine(0, 40, 50, 40)}, LinkKind::kShadow}});
  ASSERT_EQ(edited.graph.links.size(), 4u);
  EXPECT_EQ(DegreeAt(edited.graph, place), 2);
  EXPECT_EQ(testing::ContinuationsAt(edited.graph, place).size(), 1u);
  EXPECT_THAT(edited.touched, ElementsAre(0, 0, 1, 1));
  // Later edits see the halves.
  EXPECT_EQ(edited.graph.links[2].kind, LinkKind::kShadow);
  EXPECT_EQ(edited.graph.links[3].kind, LinkKind::kUnknown);
}

TEST(ApplyEdits, ALinkOfTwoPointsIsSplitInBetween) {
  const DrawingGraph graph = GraphOf({testing::InWorld({{0, 0}, {100, 0}})});
  const EditedDrawing edited =
      Edited(graph, {SplitLink{{RefToLine(0, 0, 100, 0), FrontalPoint(30, 0)}}});
  ASSERT_EQ(edited.graph.links.size(), 2u);
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 30 * kFrontalPx, 1e-9);
}

TEST(ApplyEdits, IsNotSplitAtItsEndOrFarFromIt) {
  const LinkRef ref = RefToLine(0, 40, 120, 40);
  const EditOutcome end = Refused(ThreeLines(), SplitLink{{ref, FrontalPoint(1, 40)}});
  EXPECT_EQ(end.status, EditStatus::kNoSense);
  const EditOutcome far = Refused(ThreeLines(), SplitLink{{ref, FrontalPoint(50, 60)}});
  EXPECT_EQ(far.status, EditStatus::kNotFound);
  EXPECT_THAT(far.text, HasSubstr("20 px from link 2"));
}

TEST(ApplyEdits, TheSecondCutOfARingMakesItTwo) {
  const DrawingGraph graph = GraphOf({DenseRing(0, 0, 50)});
  const LinkRef ring = RefTo(graph.links[0].points_in_world);
  const EditedDrawing once = Edited(graph, {SplitLink{{ring, FrontalPoint(0, 50)}}});
  ASSERT_EQ(once.graph.links.size(), 1u);
  EXPECT_TRUE(once.graph.links[0].closed);
  EXPECT_NEAR((once.graph.nodes[0].position_in_world - FrontalPoint(0, 50)).norm(), 0,
              0.25 * kFrontalPx);
  const EditedDrawing twice = Edited(
      graph, {SplitLink{{ring, FrontalPoint(0, 50)}}, SplitLink{{ring, FrontalPoint(0, -50)}}});
  ASSERT_EQ(twice.graph.links.size(), 2u);
  EXPECT_EQ(twice.graph.nodes.size(), 2u);
  for (const DrawingLink& link : twice.graph.links) {
    EXPECT_NEAR(Length(link.points_in_world), M_PI * 50 * kFrontalPx, 0.2 * kFrontalPx);
    EXPECT_FALSE(link.closed);
  }
  EXPECT_THAT(twice.touched, ElementsAre(1, 1));
  // The first cut may be where the ring begins; the same cut again makes no sense.
  const EditedDrawing at_start =
      Edited(graph, {SplitLink{{ring, FrontalPoint(50, 0)}}, SplitLink{{ring, FrontalPoint(50, 0)}},
                     SplitLink{{ring, FrontalPoint(-50, 0)}}});
  EXPECT_EQ(at_start.graph.links.size(), 2u);
  EXPECT_EQ(at_start.outcomes[1].status, EditStatus::kNoSense);
}

TEST(ApplyEdits, DimensionsAreAddedAndRemoved) {
  const AddDimension dimension = {{RefToLine(0, 0, 60, 0), FrontalPoint(0, 0)},
                                  {RefToLine(0, 40, 120, 40), FrontalPoint(0, 41)},
                                  {0, 0, 1}};
  const EditedDrawing edited = Edited(ThreeLines(), {dimension});
  ASSERT_EQ(edited.graph.dimensions.size(), 1u);
  EXPECT_EQ(edited.graph.dimensions[0].to, FrontalPoint(0, 40));
  EXPECT_EQ(edited.graph.dimensions[0].shift, Eigen::Vector3d(0, 0, 1));
  EXPECT_THAT(edited.new_dimension, ElementsAre(1));
  const EditedDrawing none =
      Edited(edited.graph, {RemoveDimension{FrontalPoint(1, 40), FrontalPoint(0, 1)}});
  EXPECT_THAT(none.graph.dimensions, IsEmpty());
  const EditedDrawing still =
      Edited(edited.graph, {RemoveDimension{FrontalPoint(0, 44), FrontalPoint(0, 0)}});
  EXPECT_EQ(still.graph.dimensions.size(), 1u);
  EXPECT_EQ(still.outcomes[0].status, EditStatus::kNotFound);
}

TEST(ApplyEdits, NewDimensionsFollowTheLinks) {
  EditedDrawing edited =
      Edited(ThreeLines(), {AddDimension{{RefToLine(0, 0, 60, 0), FrontalPoint(30, 0)},
                                         {RefToLine(0, 40, 120, 40), FrontalPoint(0, 40)},
                                         {0, 0, 0}}});
  edited.graph.dimensions.push_back({FrontalPoint(30, 1), FrontalPoint(30, 41), {0, 0, 0}});
  edited.new_dimension.push_back(0);
  edited.touched[2] = 1;
  for (DrawingLink& link : edited.graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point += FrontalPoint(0.5, -1);
  }
  SnapDimensions(testing::EditViews(), &edited);
  const auto& [added, stored] = std::tie(edited.graph.dimensions[0], edited.graph.dimensions[1]);
  EXPECT_NEAR((added.from - FrontalPoint(30, -1)).norm(), 0, 1e-9);
  EXPECT_EQ(added.to, FrontalPoint(0.5, 39));   // the end
  EXPECT_EQ(stored.from, FrontalPoint(30, 1));  // its link was not touched
  EXPECT_NEAR((stored.to - FrontalPoint(30, 39)).norm(), 0, 1e-9);
}

TEST(ApplyEdits, APlaceOfADimensionNearAnEndIsTheEnd) {
  const LinkRef line = RefToLine(0, 40, 120, 40);
  const EditedDrawing edited = Edited(
      ThreeLines(),
      {AddDimension{{line, FrontalPoint(1.5, 40)}, {line, FrontalPoint(117, 40)}, {0, 0, 0}}});
  ASSERT_EQ(edited.graph.dimensions.size(), 1u);
  EXPECT_EQ(edited.graph.dimensions[0].from, FrontalPoint(0, 40));
  EXPECT_NEAR((edited.graph.dimensions[0].to - FrontalPoint(117, 40)).norm(), 0, 1e-9);
  const EditOutcome both =
      Refused(ThreeLines(),
              AddDimension{{line, FrontalPoint(0.5, 40)}, {line, FrontalPoint(1, 40)}, {0, 0, 0}});
  EXPECT_EQ(both.status, EditStatus::kNoSense);
}

TEST(ApplyEdits, FacesStayWithTheirLinksElseTheyAreDroppedAndCounted) {
  DrawingGraph graph = ThreeLines();
  DrawingFace face;
  face.vertices = {FrontalPoint(0, 0), FrontalPoint(60, 0), FrontalPoint(60, 40)};
  face.triangles = {{0, 1, 2}};
  graph.faces = {face};
  const LinkRef line = RefToLine(0, 40, 120, 40);
  const AddDimension dimension = {
      {line, line.points.front()}, {line, line.points.back()}, {0, 0, 0}};
  const EditedDrawing same =
      ApplyEdits(graph, testing::EditViews(), {SetLinkKind{{line}, LinkKind::kPaint}, dimension},
                 TopologyOptions());
  EXPECT_EQ(same.graph.faces.size(), 1u);
  EXPECT_EQ(same.num_dropped_faces, 0u);
  for (const Edit& edit :
       std::vector<Edit>{DeleteLinks{{line}}, SplitLink{{line, line.points[7]}}}) {
    const EditedDrawing edited = ApplyEdits(graph, testing::EditViews(), {edit}, TopologyOptions());
    EXPECT_THAT(edited.graph.faces, IsEmpty());
    EXPECT_EQ(edited.num_dropped_faces, 1u);
  }
}

TEST(ApplyEdits, EverythingMovesWithTheOrigin) {
  const Eigen::Vector3d shift(3, -2, 1);
  const LinkRef ref = RefToLine(0, 0, 60, 0);
  const std::vector<Edit> moved =
      Moved({DeleteLinks{{ref}}, JoinEnds{{EndRef{ref, 0}, EndRef{ref, 1}}},
             AddDimension{{ref, ref.points[0]}, {ref, ref.points[1]}, {1, 0, 0}},
             RemoveDimension{ref.points[0], ref.points[1]}},
            shift);
  const Eigen::Vector3d first = ref.points[0] + shift;
  EXPECT_EQ(std::get<DeleteLinks>(moved[0]).links[0].points[0], first);
  EXPECT_EQ(std::get<JoinEnds>(moved[1]).ends[1].link.points[0], first);
  EXPECT_EQ(std::get<AddDimension>(moved[2]).from.at, first);
  EXPECT_EQ(std::get<AddDimension>(moved[2]).to.link.points[0], first);
  EXPECT_EQ(std::get<AddDimension>(moved[2]).shift, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(std::get<RemoveDimension>(moved[3]).from, first);
}

}  // namespace
}  // namespace limn
