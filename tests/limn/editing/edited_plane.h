// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "limn/editing/apply_edits.h"
#include "limn/topology/frontal_lines.h"
#include "limn/topology/graph_fixture.h"

namespace limn::testing {

// Views of a plane on which a pixel is equally large everywhere.
inline const std::vector<View>& EditViews() {
  static const std::vector<View> views = FrontalViews(3, 2, 0.5);
  return views;
}

// A line of the plane with a point every 3 px or less.
inline Polyline3d DenseLine(double x0, double y0, double x1, double y1) {
  return ResampleUniform(InWorld({{x0, y0}, {x1, y1}}), 3 * kFrontalPx);
}

inline Polyline3d DenseRing(double x, double y, double radius) {
  Polyline3d ring;
  constexpr int kCount = 60;
  for (int k = 0; k < kCount; ++k) {
    const double angle = 2 * M_PI * k / kCount;
    ring.push_back(FrontalPoint(x + radius * std::cos(angle), y + radius * std::sin(angle)));
  }
  ring.push_back(ring.front());
  return ring;
}

// What the page writes of a link: at most 16 points.
inline LinkRef RefTo(const Polyline3d& points, LinkId id = -1) {
  LinkRef ref;
  ref.id = id;
  ref.closed = points.front() == points.back();
  const double length = Length(points);
  ref.points = ResampleUniform(points, length / 14.999);
  return ref;
}
inline LinkRef RefToLine(double x0, double y0, double x1, double y1, LinkId id = -1) {
  return RefTo(DenseLine(x0, y0, x1, y1), id);
}

// The result of edits, which must be valid.
inline EditedDrawing Edited(const DrawingGraph& graph, const std::vector<Edit>& edits) {
  EditedDrawing edited = ApplyEdits(graph, EditViews(), edits, TopologyOptions());
  ExpectValid(edited.graph);
  EXPECT_EQ(edited.touched.size(), edited.graph.links.size());
  EXPECT_EQ(edited.kind_by_hand.size(), edited.graph.links.size());
  EXPECT_EQ(edited.new_dimension.size(), edited.graph.dimensions.size());
  EXPECT_EQ(edited.outcomes.size(), edits.size());
  return edited;
}

// An edit that must leave the drawing as it is.
inline EditOutcome Refused(const DrawingGraph& graph, const Edit& edit) {
  const EditedDrawing edited = Edited(graph, {edit});
  EXPECT_EQ(edited.graph.links.size(), graph.links.size());
  for (size_t l = 0; l < std::min(graph.links.size(), edited.graph.links.size()); ++l) {
    EXPECT_EQ(edited.graph.links[l].points_in_world, graph.links[l].points_in_world);
    EXPECT_FALSE(edited.touched[l]);
  }
  return edited.outcomes[0];
}

}  // namespace limn::testing
