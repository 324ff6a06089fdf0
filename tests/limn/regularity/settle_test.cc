// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/settle.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/primitives/fit_primitives.h"
#include "support/noisy_drawing.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Short and long lines along x, and lines along y, in the plane z = 0. One more, along x, is above.
struct FlatLines {
  static constexpr int kNumInPlane = 9;
  static constexpr int kAbove = 9;

  DrawingGraph graph;
  DrawingEvidence evidence;

  FlatLines() {
    testing::NoisyDrawing drawing;
    const auto add = [&](const Vector3d& from, const Vector3d& to) {
      const NodeId node0 = drawing.AddNode(from + drawing.Noise());
      const NodeId node1 = drawing.AddNode(to + drawing.Noise());
      drawing.AddLink(node0, node1, testing::LineCurve(from, to), (to - from).norm());
    };
    for (int i = 0; i < 3; ++i) {
      const double at = 0.12 * i - 0.35;
      add({-0.1, at, 0}, {0.1, at, 0});                  // 0, 3, 6
      add({-0.45, at + 0.05, 0}, {0.45, at + 0.05, 0});  // 1, 4, 7
      add({at, 0.1, 0}, {at, 0.45, 0});                  // 2, 5, 8
    }
    add({-0.3, 0.02, 4 * testing::kNoisyDrawingPx}, {0.3, 0.02, 4 * testing::kNoisyDrawingPx});
    graph = FitPrimitives(drawing.graph(), testing::ViewsOfNoisyDrawing(), {}, {}).graph;
    evidence = MeasureEvidence(graph, testing::ViewsOfNoisyDrawing(), {}, {});
  }

  // Evidence is by link, and all links are lines. `turn_rad`: of the direction along x.
  RegularityClasses Classes(double turn_rad) const {
    RegularityClasses classes;
    DirectionClass x, y;
    x.direction = {std::cos(turn_rad), std::sin(turn_rad), 0};
    y.direction = Vector3d::UnitY();
    x.lines = {0, 1, 3, 4, 6, 7, kAbove};
    y.lines = {2, 5, 8};
    classes.directions = {x, y};
    PlaneClass plane;
    plane.offset = -evidence.unit.origin.z() / evidence.unit.length;
    for (int i = 0; i < kNumInPlane; ++i) plane.lines.push_back(i);
    classes.planes = {plane};
    return classes;
  }

  SettledRegularities Settled(RegularityClasses classes) const {
    return SettleRegularities(graph, evidence, {}, std::move(classes), {});
  }
};

TEST(SettleRegularities, LinksLeaveOnlyWhatStrainsThem) {
  const FlatLines flat;
  RegularityClasses classes = flat.Classes(0);
  classes.planes[0].lines.push_back(FlatLines::kAbove);
  const SettledRegularities settled = flat.Settled(classes);
  ASSERT_EQ(settled.classes.directions.size(), 2u);
  EXPECT_EQ(settled.classes.directions[0].lines, classes.directions[0].lines);
  EXPECT_EQ(settled.classes.directions[1].lines, classes.directions[1].lines);
  ASSERT_EQ(settled.classes.planes.size(), 1u);
  EXPECT_EQ(settled.classes.planes[0].lines, flat.Classes(0).planes[0].lines);
  EXPECT_THAT(settled.let_go, ::testing::IsEmpty());
}

TEST(SettleRegularities, WhatLeftIsTriedAgain) {
  // The long lines are strained by the direction as it is first, the short ones turn it.
  const FlatLines flat;
  const RegularityClasses classes = flat.Classes(1.5 * testing::kNoisyDrawingPx / 0.45);
  const SettledRegularities settled = flat.Settled(classes);
  ASSERT_EQ(settled.classes.directions.size(), 2u);
  EXPECT_EQ(settled.classes.directions[0].lines, classes.directions[0].lines);
  EXPECT_LT(settled.classes.directions[0].direction.cross(Vector3d::UnitX()).norm(),
            0.2 * testing::kNoisyDrawingPx / 0.45);
}

TEST(SettleRegularities, APlaneThatTooFewFollowEnds) {
  const FlatLines flat;
  RegularityClasses classes = flat.Classes(0);
  classes.planes[0].lines = {0, 3, FlatLines::kAbove};
  const SettledRegularities settled = flat.Settled(classes);
  EXPECT_THAT(settled.classes.planes, ::testing::IsEmpty());
  EXPECT_EQ(settled.classes.directions.size(), 2u);
}

TEST(SettleRegularities, APlaneOfParallelLinesDoesNotSaveItsNormal) {
  const FlatLines flat;
  RegularityClasses classes = flat.Classes(0);
  const auto saves = [&] {
    return SavesItsNormal(classes.planes[0], flat.graph, flat.evidence, classes.directions, {});
  };
  EXPECT_TRUE(saves());
  classes.planes[0].lines = {0, 1, 3, 4, 6, 7};
  EXPECT_FALSE(saves());
  EXPECT_THAT(flat.Settled(classes).classes.planes, ::testing::IsEmpty());
}

TEST(LeaveRegularities, TiesToADirectionWithoutLinesEnd) {
  const FlatLines flat;
  RegularityClasses classes = flat.Classes(0);
  classes.directions[0].orthogonal_to = {1};
  classes.directions[1].orthogonal_to = {0};
  classes.planes[0].normal_class = 0;
  std::set<Membership> leaving;
  for (const int i : {0, 1, 3, 4, 6, 7}) {
    leaving.insert({flat.evidence.lines[i].link, RegularityKind::kDirection, 0, i});
  }
  Leave(leaving, flat.evidence, &classes);
  EXPECT_THAT(classes.directions[0].lines, ::testing::IsEmpty());  // one alone shares nothing
  EXPECT_THAT(classes.directions[1].orthogonal_to, ::testing::IsEmpty());
  EXPECT_EQ(classes.planes[0].normal_class, -1);
  RegularityClasses joined = classes;
  Join({*leaving.begin()}, flat.evidence, &joined);
  EXPECT_THAT(joined.directions[0].lines, ::testing::IsEmpty());
  Join(leaving, flat.evidence, &joined);
  EXPECT_THAT(joined.directions[0].lines, ::testing::ElementsAre(0, 1, 3, 4, 6, 7));
  RemoveEmpty(&classes);
  ASSERT_EQ(classes.directions.size(), 1u);
  EXPECT_THAT(classes.directions[0].lines, ::testing::ElementsAre(2, 5, 8));
}

}  // namespace
}  // namespace limn
