// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/refit_edited.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using ::testing::HasSubstr;
using testing::kFrontalPx;

constexpr int kNumEditedViews = 8;

const std::vector<View>& EditedViews() {
  static const std::vector<View> views = testing::FrontalViews(4, 2, 1);
  return views;
}

Polyline3d EditedLine(double x0, double x1, double y) {
  return ResampleUniform(std::vector<Eigen::Vector3d>{FrontalPoint(x0, y), FrontalPoint(x1, y)},
                         3 * kFrontalPx);
}

// Lines that begin and end at nodes of their own.
DrawingGraph EditedGraph(const std::vector<Polyline3d>& lines) {
  DrawingGraph graph;
  for (const Polyline3d& points : lines) {
    DrawingLink link;
    link.points_in_world = points;
    link.sigma.assign(points.size(), 0.2 * kFrontalPx);
    link.node0 = static_cast<NodeId>(graph.nodes.size());
    link.node1 = link.node0 + 1;
    for (int v = 0; v < kNumEditedViews; ++v) link.supporting_views.push_back(v);
    graph.nodes.resize(graph.nodes.size() + 2);
    graph.nodes[link.node0].position_in_world = points.front();
    graph.nodes[link.node1].position_in_world = points.back();
    graph.links.push_back(std::move(link));
  }
  RebuildIncidence(&graph);
  return graph;
}

LinkRef RefToEdited(const Polyline3d& points) {
  return {-1, false, ResampleUniform(points, Length(points) / 8)};
}

// Joins the ends of two lines, x from -100 to -20 and from 20 to 100, .3 px beside edges of the
// images, which have such parts.
EditedDrawing JoinedOver(const std::vector<testing::SceneCurve>& edges, bool with_dimension) {
  const Polyline3d left = EditedLine(-100, -20, 0.3);
  const Polyline3d right = EditedLine(20, 100, 0.3);
  std::vector<Edit> edits = {
      JoinEnds{{EndRef{RefToEdited(left), 1}, EndRef{RefToEdited(right), 0}}}};
  if (with_dimension) {
    edits.push_back(AddDimension{{RefToEdited(left), FrontalPoint(-60, 0.3)},
                                 {RefToEdited(right), FrontalPoint(60, 0.3)},
                                 {0, 0, 0}});
    std::swap(edits[0], edits[1]);
  }
  EditedDrawing edited =
      ApplyEdits(EditedGraph({left, right}), EditedViews(), edits, TopologyOptions());
  const std::vector<ImageCurves> curves = testing::ProjectCurves(EditedViews(), edges);
  RefitEdited({EditedViews(), curves}, {}, {}, {}, &edited);
  EXPECT_THAT(Validate(edited.graph), ::testing::IsEmpty());
  EXPECT_EQ(edited.graph.links.size(), 1u);
  return edited;
}

testing::SceneCurve Edge(double x0, double x1) {
  return testing::Segment(FrontalPoint(x0, 0), FrontalPoint(x1, 0));
}

TEST(RefitEdited, AGapThatTheImagesShowIsClosedAndFitted) {
  const EditedDrawing edited = JoinedOver({Edge(-100, 100)}, false);
  EXPECT_EQ(edited.outcomes[0].warning, "");
  const DrawingLink& link = edited.graph.links[0];
  ASSERT_TRUE(link.primitive);
  EXPECT_TRUE(std::holds_alternative<LineSegment>(link.primitive->shape));
  for (const Eigen::Vector3d& point : link.points_in_world) {
    EXPECT_NEAR(point.y(), 0, 0.06 * kFrontalPx);
  }
}

TEST(RefitEdited, AGapThatTheyDoNotShowIsClosedAndTold) {
  const EditedDrawing edited = JoinedOver({Edge(-100, -20), Edge(20, 100)}, false);
  EXPECT_EQ(edited.outcomes[0].status, EditStatus::kApplied);
  EXPECT_THAT(edited.outcomes[0].warning, HasSubstr("no edge along most of the gap of 40 px"));
  // In the middle of the gap the link is less sure than elsewhere.
  const DrawingLink& link = edited.graph.links[0];
  const double middle = link.sigma[ClosestPoint(link.points_in_world, FrontalPoint(0, 0)).segment];
  const double beside =
      link.sigma[ClosestPoint(link.points_in_world, FrontalPoint(-60, 0)).segment];
  EXPECT_GT(middle, 2 * beside);
}

TEST(RefitEdited, DimensionsAreOnTheFittedLinks) {
  const EditedDrawing edited = JoinedOver({Edge(-100, 100)}, true);
  ASSERT_EQ(edited.graph.dimensions.size(), 1u);
  const auto& [from, to, shift, sigma] = edited.graph.dimensions[0];
  EXPECT_NEAR(from.y(), 0, 0.06 * kFrontalPx);
  EXPECT_NEAR(to.y(), 0, 0.06 * kFrontalPx);
  EXPECT_NEAR((to - from).norm(), 120 * kFrontalPx, 0.5 * kFrontalPx);
}

}  // namespace
}  // namespace limn
