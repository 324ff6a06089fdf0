// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/smooth_outlines.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "limn/kinds/outline_fit.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/graph_editor.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kDistance = 5;
constexpr double kPx = kDistance / 600;
constexpr double kBodyRadius = 24 * kPx;
constexpr double kHalfHeight = 0.8;

// Views of the z axis, 5 degrees apart.
std::vector<View> RingOfViews() {
  std::vector<View> views;
  for (int i = -9; i <= 9; ++i) views.push_back(testing::RingView(5 * i, kDistance));
  return views;
}

Polyline3d Upright(double x, double y) {
  Polyline3d line;
  for (int k = -20; k <= 20; ++k) line.push_back({x, y, kHalfHeight * k / 20});
  return line;
}

// Where a view sees the outline of an upright cylinder of this radius around the z axis; side 1 or
// -1. It is dark before a bright wall.
testing::SceneCurve OutlineOf(const View& view, double radius, int side) {
  const Eigen::Vector3d center = view.CenterInWorld();
  const double angle = std::atan2(center.y(), center.x()) + side * std::acos(radius / kDistance);
  testing::SceneCurve outline = {Upright(radius * std::cos(angle), radius * std::sin(angle)),
                                 false};
  if (side > 0) std::reverse(outline.points.begin(), outline.points.end());
  return outline;
}

std::vector<ImageCurves> CylinderIn(const std::vector<View>& views, double radius) {
  std::vector<ImageCurves> curves;
  for (const View& view : views) {
    curves.push_back(testing::ProjectCurves(
        view, {OutlineOf(view, radius, 1), OutlineOf(view, radius, -1)}, 0.1));
  }
  return curves;
}

DrawingGraph Drawing(const std::vector<Polyline3d>& lines) {
  DrawingGraph graph;
  GraphEditor editor(&graph);
  for (const Polyline3d& line : lines) {
    DrawingLink link;
    link.points_in_world = line;
    link.sigma.assign(line.size(), 0.1 * kPx);
    editor.Add(std::move(link));
  }
  return graph;
}

// What two groups of views make of either outline of a cylinder.
DrawingGraph WaveringLines(const std::vector<View>& views, double radius) {
  std::vector<Polyline3d> lines;
  for (const size_t view : {6, 12}) {
    for (const int side : {1, -1}) lines.push_back(OutlineOf(views[view], radius, side).points);
  }
  return Drawing(lines);
}

std::vector<LinkKind> KindsIn(const std::vector<View>& views,
                              const std::vector<ImageCurves>& curves, const DrawingGraph& graph) {
  std::vector<LinkKind> kinds;
  const OutlinesResult result = FindSmoothOutlines({{views, curves}, graph}, {});
  for (const DrawingLink& link : result.graph.links) kinds.push_back(link.kind);
  return kinds;
}

OutlineEvidence EvidenceOf(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                           const DrawingLink& link) {
  const auto edgels = BuildViewEdgels(curves, {});
  return CompareWithBodies({views, curves, edgels, {}}, ViewFinder(views), link);
}

TEST(SmoothOutlinesTest, LinesAlongTheOutlinesOfACylinderAreContours) {
  const auto views = RingOfViews();
  EXPECT_EQ(KindsIn(views, CylinderIn(views, kBodyRadius), WaveringLines(views, kBodyRadius)),
            std::vector<LinkKind>(4, LinkKind::kContour));
}

TEST(SmoothOutlinesTest, RadiusAndAxisOfTheCylinderAreFound) {
  const auto views = RingOfViews();
  const DrawingGraph graph = WaveringLines(views, kBodyRadius);
  const auto curves = CylinderIn(views, kBodyRadius);
  for (const DrawingLink& link : graph.links) {
    const OutlineEvidence evidence = EvidenceOf(views, curves, link);
    EXPECT_NEAR(std::abs(evidence.body.radius), kBodyRadius, 0.05 * kBodyRadius);
    for (const Eigen::Vector3d& center : evidence.body.axis) {
      EXPECT_LT(center.head<2>().norm(), 2 * kPx);
    }
  }
}

TEST(SmoothOutlinesTest, OutlinesTellTheCylinder) {
  const auto views = RingOfViews();
  const auto curves = CylinderIn(views, kBodyRadius);
  const OutlinesResult result =
      FindSmoothOutlines({{views, curves}, WaveringLines(views, kBodyRadius)}, {});
  ASSERT_EQ(result.graph.links.size(), 4u);
  for (const DrawingLink& link : result.graph.links) {
    ASSERT_TRUE(link.body);
    EXPECT_EQ(link.body, result.graph.links[0].body);
    EXPECT_EQ(link.body->shape, RoundShape::kCylinder);
    EXPECT_NEAR(link.body->start_radius, kBodyRadius, 0.02 * kBodyRadius);
    EXPECT_LT(link.body->start.head<2>().norm(), kPx);
    EXPECT_LT(link.body->end.head<2>().norm(), kPx);
    EXPECT_GT(std::abs(link.body->end.z() - link.body->start.z()), 1.8 * kHalfHeight);
  }
  EXPECT_FALSE(WithoutOutlines(result.graph).links[0].body);
}

TEST(SmoothOutlinesTest, EdgesOfASquareBarAreEdges) {
  const auto views = RingOfViews();
  std::vector<testing::SceneCurve> edges;
  std::vector<Polyline3d> lines;
  for (const double x : {-kBodyRadius, kBodyRadius}) {
    for (const double y : {-kBodyRadius, kBodyRadius}) {
      lines.push_back(Upright(x, y));
      edges.push_back({lines.back(), false});
    }
  }
  EXPECT_EQ(KindsIn(views, testing::ProjectCurves(views, edges, 0.1), Drawing(lines)),
            std::vector<LinkKind>(4, LinkKind::kUnknown));
}

TEST(SmoothOutlinesTest, AnEdgeThatFewViewsShowIsOne) {
  const auto views = RingOfViews();
  const testing::SceneCurve edge = {Upright(kBodyRadius, 0), false};
  auto curves = testing::ProjectCurves(views, {edge});
  for (size_t v = 0; v < views.size(); ++v) {
    if (v < 7 || v > 11) curves[v] = {};
  }
  EXPECT_EQ(KindsIn(views, curves, Drawing({edge.points})),
            std::vector<LinkKind>{LinkKind::kUnknown});
}

// Its outlines move by less than blur and cameras do.
TEST(SmoothOutlinesTest, ARoundedEdgeIsAnEdge) {
  const auto views = RingOfViews();
  constexpr double kSmall = 2.6 * kPx;
  EXPECT_EQ(KindsIn(views, CylinderIn(views, kSmall), WaveringLines(views, kSmall)),
            std::vector<LinkKind>(4, LinkKind::kUnknown));
}

TEST(SmoothOutlinesTest, OutlinesHaveOneBrighterSide) {
  const auto views = RingOfViews();
  std::vector<ImageCurves> curves;
  for (size_t v = 0; v < views.size(); ++v) {
    testing::SceneCurve outline = OutlineOf(views[v], kBodyRadius, 1);
    const bool is_near = v >= 4 && v <= 8;
    if (!is_near) std::reverse(outline.points.begin(), outline.points.end());
    curves.push_back(testing::ProjectCurves(views[v], {outline}));
  }
  EXPECT_EQ(KindsIn(views, curves, Drawing({OutlineOf(views[6], kBodyRadius, 1).points})),
            std::vector<LinkKind>{LinkKind::kUnknown});
}

TEST(SmoothOutlinesTest, TentativeLinksAreNotJudged) {
  const auto views = RingOfViews();
  DrawingGraph graph = WaveringLines(views, kBodyRadius);
  graph.links[0].tentative = true;
  EXPECT_EQ(KindsIn(views, CylinderIn(views, kBodyRadius), graph)[0], LinkKind::kUnknown);
}

TEST(SmoothOutlinesTest, ContoursAreJudgedAnew) {
  const auto views = RingOfViews();
  const testing::SceneCurve edge = {Upright(kBodyRadius, 0), false};
  DrawingGraph graph = Drawing({edge.points});
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 0.8;
  EXPECT_EQ(KindsIn(views, testing::ProjectCurves(views, {edge}), graph),
            std::vector<LinkKind>{LinkKind::kUnknown});
}

}  // namespace
}  // namespace limn
