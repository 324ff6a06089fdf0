// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/kind_confusion.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

void AddLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, LinkKind kind,
             DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world = {from, to};
  link.sigma = {0, 0};
  link.node0 = static_cast<NodeId>(graph->nodes.size());
  link.node1 = link.node0 + 1;
  link.kind = kind;
  graph->nodes.resize(graph->nodes.size() + 2);
  graph->nodes[link.node0].position_in_world = from;
  graph->nodes[link.node1].position_in_world = to;
  if (kind == LinkKind::kRod) link.rod_radius = 0.01;
  graph->links.push_back(link);
  RebuildIncidence(graph);
  EXPECT_TRUE(Validate(*graph).empty());
}

double PointAtX(const KindConfusion& confusion, LinkKind true_kind, LinkKind kind) {
  return confusion.length[static_cast<int>(true_kind)][static_cast<int>(kind)];
}

CurvesByKind TruthWith(const std::vector<std::pair<LinkKind, Polyline3d>>& curves) {
  CurvesByKind truth;
  for (const auto& [kind, points] : curves) {
    truth[static_cast<int>(kind)].polylines.push_back(points);
  }
  return truth;
}

constexpr double kNearby = 0.1;
// Cells are at most tau / 4 long.
constexpr double kCell = kNearby / 4;

TEST(KindConfusionTest, LengthIsThatOfTheKindNearby) {
  // A link of 2 along a true edge of 1.2, which then has nothing beside it.
  DrawingGraph drawing;
  AddLine({0, 0, 0}, {2, 0, 0}, LinkKind::kShadow, &drawing);
  AddLine({0, 5, 0}, {1, 5, 0}, LinkKind::kPaint, &drawing);
  const CurvesByKind truth = TruthWith({{LinkKind::kEdge, {{0, 0.05, 0}, {1.2, 0.05, 0}}},
                                        {LinkKind::kPaint, {{0, 5, 0}, {1, 5, 0}}}});
  const KindConfusion confusion = CompareKinds(drawing, truth, {}, {kNearby, {}});
  // The edge reaches sqrt(tau^2 - 0.05^2) beyond its end.
  EXPECT_NEAR(PointAtX(confusion, LinkKind::kEdge, LinkKind::kShadow), 1.2 + 0.0866, 2 * kCell);
  EXPECT_NEAR(PointAtX(confusion, LinkKind::kUnknown, LinkKind::kShadow), 0.8 - 0.0866, 2 * kCell);
  EXPECT_NEAR(PointAtX(confusion, LinkKind::kPaint, LinkKind::kPaint), 1, 1e-9);
  EXPECT_EQ(PointAtX(confusion, LinkKind::kPaint, LinkKind::kShadow), 0);
}

TEST(KindConfusionTest, TrueCurvesComeBeforeShadowsThatAreNearer) {
  DrawingGraph drawing;
  AddLine({0, 0, 0}, {1, 0, 0}, LinkKind::kEdge, &drawing);
  const CurvesByKind truth = TruthWith({{LinkKind::kShadow, {{-1, 0.01, 0}, {2, 0.01, 0}}},
                                        {LinkKind::kEdge, {{-1, 0.08, 0}, {2, 0.08, 0}}}});
  EXPECT_NEAR(
      PointAtX(CompareKinds(drawing, truth, {}, {kNearby, {}}), LinkKind::kEdge, LinkKind::kEdge),
      1, 1e-9);
}

TEST(KindConfusionTest, RodsAreKnownByTheirCenterLinesAlthoughTheirOutlinesAreNearer) {
  DrawingGraph drawing;
  AddLine({0, 0, 0}, {1, 0, 0}, LinkKind::kRod, &drawing);
  AddLine({0, 5, 0}, {1, 5, 0}, LinkKind::kRod, &drawing);
  const CurvesByKind truth = TruthWith({{LinkKind::kContour, {{-1, 0.01, 0}, {2, 0.01, 0}}},
                                        {LinkKind::kEdge, {{-1, 0.09, 0}, {2, 0.09, 0}}},
                                        {LinkKind::kRod, {{-1, 0.05, 0}, {2, 0.05, 0}}},
                                        {LinkKind::kContour, {{-1, 5.01, 0}, {2, 5.01, 0}}}});
  const KindConfusion confusion = CompareKinds(drawing, truth, {}, {kNearby, {}});
  EXPECT_NEAR(PointAtX(confusion, LinkKind::kRod, LinkKind::kRod), 1, 1e-9);
  EXPECT_NEAR(PointAtX(confusion, LinkKind::kContour, LinkKind::kRod), 1, 1e-9);
}

TEST(KindConfusionTest, TauIsInFootprintsOfTheViewsAndTheRegionLimits) {
  // A shadow 1.5 px beside the link.
  const std::vector<View> views = testing::FrontalViews(2, 1, 0.1);
  DrawingGraph drawing;
  AddLine(testing::FrontalPoint(-50, 0), testing::FrontalPoint(50, 0), LinkKind::kShadow, &drawing);
  const CurvesByKind truth = TruthWith(
      {{LinkKind::kShadow, {testing::FrontalPoint(-60, 1.5), testing::FrontalPoint(60, 1.5)}}});
  const double whole = 100 * testing::kFrontalPx;
  EXPECT_NEAR(
      PointAtX(CompareKinds(drawing, truth, views, {2, {}}), LinkKind::kShadow, LinkKind::kShadow),
      whole, 1e-9);
  EXPECT_NEAR(
      PointAtX(CompareKinds(drawing, truth, views, {1, {}}), LinkKind::kUnknown, LinkKind::kShadow),
      whole, 1e-9);
  KindConfusionOptions half = {
      2, Eigen::AlignedBox3d(Eigen::Vector3d(0, -1, -1), Eigen::Vector3d(9, 9, 9))};
  EXPECT_NEAR(
      PointAtX(CompareKinds(drawing, truth, views, half), LinkKind::kShadow, LinkKind::kShadow),
      whole / 2, testing::kFrontalPx);
  EXPECT_THROW(CompareKinds(drawing, truth, views, {0, {}}), OptionError);
}

TEST(KindConfusionTest, TableHasARowPerTrueKind) {
  KindConfusion confusion;
  confusion.tau = 2;
  confusion.length[static_cast<int>(LinkKind::kPaint)][static_cast<int>(LinkKind::kEdge)] = 1.25;
  std::ostringstream out;
  PrintKindConfusion(confusion, out);
  EXPECT_THAT(out.str(), ::testing::ContainsRegex("paint +1.250 +0.000"));
  EXPECT_THAT(out.str(), ::testing::HasSubstr("none"));
  EXPECT_THAT(out.str(), ::testing::HasSubstr("   contour       rod   texture   unknown\n"));
  EXPECT_THAT(out.str(), ::testing::HasSubstr("\n  rod "));
}

}  // namespace
}  // namespace limn
