// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/depth_range.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/visibility/face_surface.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using testing::FaceDrawing;

double LengthOfAll(const DrawingGraph& graph) {
  double length = 0;
  for (const DrawingLink& link : graph.links) length += Length(link.points_in_world);
  return length;
}

double AreaOfAll(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += 0.5 *
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return area;
}

TEST(DepthRange, CutsLinesOfACube) {
  const DrawingGraph cube = testing::UnitCube();
  DrawingGraph with_points = cube;
  for (DrawingLink& link : with_points.links) link.primitive.reset();
  for (const DrawingGraph& graph : {cube, with_points}) {
    const DrawingGraph low = Clipped(graph, {Eigen::Vector3d::UnitZ(), -1, 0.25});
    EXPECT_THAT(Validate(low), ::testing::IsEmpty());
    EXPECT_EQ(low.links.size(), 8u);
    EXPECT_NEAR(LengthOfAll(low), 5, 1e-9);
    EXPECT_TRUE(low.faces.empty());
    // The corners below keep their three links.
    int junctions = 0;
    for (const DrawingNode& node : low.nodes) junctions += node.kind == NodeKind::kJunction;
    EXPECT_EQ(junctions, 4);
    // Both planes cut.
    const DrawingGraph middle = Clipped(graph, {Eigen::Vector3d::UnitZ(), 0.25, 0.75});
    EXPECT_EQ(middle.links.size(), 4u);
    EXPECT_NEAR(LengthOfAll(middle), 2, 1e-9);
  }
  const DrawingGraph all = Clipped(cube, {});
  EXPECT_EQ(all.links.size(), 12u);
  EXPECT_EQ(all.nodes.size(), 8u);
}

TEST(DepthRange, CutsCirclesExactly) {
  const DrawingGraph upright = testing::Cylinder();
  const DrawingGraph half = Clipped(upright, {Eigen::Vector3d::UnitX(), 0.5, 9});
  ASSERT_EQ(half.links.size(), 4u);  // the circles begin within the range
  double turn = 0;
  for (const DrawingLink& link : half.links) {
    EXPECT_FALSE(link.closed);
    const auto& arc = std::get<CircularArc>(link.primitive->shape);
    EXPECT_EQ(arc.radius, 1);
    turn += arc.sweep_rad;
  }
  EXPECT_NEAR(turn, 2 * 2 * std::acos(0.5), 1e-9);
  EXPECT_THAT(Validate(half), ::testing::IsEmpty());
}

TEST(DepthRange, KeepsDimensionsInside) {
  DrawingGraph graph = testing::UnitCube();
  graph.dimensions = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}};
  const DrawingGraph low = Clipped(graph, {Eigen::Vector3d::UnitZ(), -1, 0.5});
  ASSERT_EQ(low.dimensions.size(), 1u);
  EXPECT_EQ(low.dimensions[0].to, Eigen::Vector3d::UnitX());
}

TEST(DepthRange, CutsFaces) {
  const TriangleMesh mesh = MeshOf(testing::UnitCube().faces);
  EXPECT_NEAR(AreaOfAll(mesh), 6, 1e-12);
  EXPECT_NEAR(AreaOfAll(Clipped(mesh, {Eigen::Vector3d::UnitZ(), -1, 0.25})), 2, 1e-12);
  EXPECT_NEAR(AreaOfAll(Clipped(mesh, {Eigen::Vector3d::UnitZ(), 0.25, 0.5})), 1, 1e-12);
}

}  // namespace
}  // namespace limn
