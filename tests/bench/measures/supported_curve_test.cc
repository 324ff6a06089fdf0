// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/supported_curve.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(SupportedCurve, ComesFromSketchAndDrawing) {
  Curve3D curve;
  curve.points_in_world = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  curve.closed = true;
  curve.support.Append(std::vector<EdgelRef>{{1, 5}, {4, 0}});
  curve.support.Append(std::vector<EdgelRef>{{0, 2}, {4, 1}});
  const auto from_sketch = ToSupportedCurves(CurveSketch{{curve}});
  ASSERT_EQ(from_sketch.size(), 1u);
  EXPECT_EQ(from_sketch[0].supporting_views, (std::vector<ViewId>{0, 1, 4}));
  EXPECT_EQ(from_sketch[0].points_in_world.size(), 4u);

  DrawingGraph graph;
  graph.links.resize(1);
  graph.links[0].points_in_world = {{0, 0, 0}, {1, 0, 0}};
  graph.links[0].supporting_views = {3, 7};
  const auto from_drawing = ToSupportedCurves(graph);
  ASSERT_EQ(from_drawing.size(), 1u);
  EXPECT_EQ(from_drawing[0].supporting_views, (std::vector<ViewId>{3, 7}));
}

}  // namespace
}  // namespace limn
