// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/section.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limn/geometry/polygon2d.h"
#include "limn/model/drawing_transform.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

Section CutOf(const DrawingGraph& graph, double height, double gap = 0) {
  return CutAt(height, graph.faces, graph.links, gap);
}

double AreaWithin(const SectionLine& line) {
  Polyline2d corners;
  for (const Eigen::Vector3d& point : line.points) corners.push_back(point.head<2>());
  return std::abs(SignedArea(corners));
}

double LengthAround(const SectionLine& line) {
  return Length(line.points) +
         (line.closed ? (line.points.front() - line.points.back()).norm() : 0);
}

TEST(Section, OfACubeIsASquare) {
  // At its top too; the base, in the plane of the cut, counts as above it.
  for (const double height : {0.5, 0.1, 1.0}) {
    const Section section = CutOf(testing::UnitCube(), height);
    ASSERT_EQ(section.lines.size(), 1u);
    EXPECT_TRUE(section.lines[0].closed);
    EXPECT_EQ(section.NumClosed(), 1);
    EXPECT_EQ(section.lines[0].points.size(), 4u);
    EXPECT_NEAR(LengthAround(section.lines[0]), 4, 1e-12);
    EXPECT_NEAR(AreaWithin(section.lines[0]), 1, 1e-12);
    EXPECT_EQ(section.points.size(), 4u);
    for (const Eigen::Vector3d& point : section.points) EXPECT_EQ(point.z(), height);
  }
  for (const double height : {0.0, 1.5}) {
    EXPECT_TRUE(CutOf(testing::UnitCube(), height).lines.empty());
    EXPECT_TRUE(CutOf(testing::UnitCube(), height).points.empty());
  }
}

TEST(Section, OfARoundBodyIsClosed) {
  const Section section = CutOf(testing::Cylinder(0.5), 1);
  ASSERT_EQ(section.lines.size(), 1u);
  EXPECT_TRUE(section.lines[0].closed);
  EXPECT_NEAR(LengthAround(section.lines[0]), 2 * std::numbers::pi * 0.75, 0.01);
}

// Faces that were fitted to their own links end near each other.
DrawingGraph Apart(double distance) {
  DrawingGraph graph = testing::UnitCube();
  for (DrawingFace& face : graph.faces) {
    for (Eigen::Vector3d& vertex : face.vertices) vertex += distance * face.normal;
  }
  return graph;
}

TEST(Section, GapsAreClosedAtTheCorner) {
  const DrawingGraph graph = Apart(0.01);
  const Section closed = CutOf(graph, 0.5, 0.02);
  ASSERT_EQ(closed.lines.size(), 1u);
  EXPECT_TRUE(closed.lines[0].closed);
  // To where both walls meet.
  EXPECT_EQ(closed.lines[0].points.size(), 4u);
  EXPECT_NEAR(AreaWithin(closed.lines[0]), 1.02 * 1.02, 1e-12);
  const Section open = CutOf(graph, 0.5, 0.01);
  EXPECT_EQ(open.lines.size(), 4u);
  EXPECT_EQ(open.NumClosed(), 0);
}

TEST(Section, AMissingWallLeavesItOpen) {
  DrawingGraph graph = testing::UnitCube();
  graph.faces.erase(graph.faces.begin() + 2);
  const Section section = CutOf(graph, 0.5, 0.01);
  ASSERT_EQ(section.lines.size(), 1u);
  EXPECT_FALSE(section.lines[0].closed);
  EXPECT_NEAR(LengthAround(section.lines[0]), 3, 1e-12);
  EXPECT_EQ(section.lines[0].points.size(), 4u);
}

TEST(Section, AHoleIsALineOfItsOwn) {
  // A plate that stands, with a hole.
  Eigen::Matrix3d up;
  up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const DrawingGraph plate = Transformed(testing::PlateWithHole(), 1, up, Eigen::Vector3d::Zero());
  const Section section = CutOf(plate, 1.0, 0.01);
  ASSERT_EQ(section.lines.size(), 2u);
  EXPECT_NEAR(LengthAround(section.lines[0]) + LengthAround(section.lines[1]), 2, 0.01);
}

TEST(Section, TheUsualGapGrowsWithTheSigmas) {
  DrawingGraph graph = testing::UnitCube();
  for (DrawingLink& link : graph.links) std::fill(link.sigma.begin(), link.sigma.end(), 0.25);
  EXPECT_EQ(UsualGap(graph.links), 4);
  EXPECT_EQ(UsualGap({}), 0);
}

}  // namespace
}  // namespace limn
