// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/ruled_candidates.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limn/surfaces/bent_fixture.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using testing::FaceDrawing;

CircularArc Arc(const Eigen::Vector3d& center, double radius, double sweep_rad) {
  CircularArc arc;
  arc.center = center;
  arc.radius = radius;
  arc.sweep_rad = sweep_rad;
  return arc;
}

std::vector<BentCandidate> CandidatesOf(const DrawingGraph& graph) {
  return testing::BentCandidatesOf(graph, FindRuledCandidates);
}

TEST(RuledCandidates, BetweenNeighboringCircles) {
  FaceDrawing drawing;
  for (const double z : {0.0, 1.0, 1.5}) {
    drawing.AddShape(Arc({0, 0, z}, 1, 2 * std::numbers::pi));
  }
  drawing.AddShape(Arc({0, 0, 2}, 0.5, 2 * std::numbers::pi));
  const auto candidates = CandidatesOf(drawing.graph());
  ASSERT_EQ(candidates.size(), 2u);
  for (const BentCandidate& ruled : candidates) {
    EXPECT_EQ(ruled.face.surface, FaceSurface::kRuled);
    EXPECT_EQ(ruled.face.loops.size(), 2u);
    const double height = std::abs(ruled.face.vertices[1].z() - ruled.face.vertices[0].z());
    EXPECT_NEAR(AreaOf(ruled.face), 2 * std::numbers::pi * height, 0.02 * height);
    for (const CandidatePlace& place : ruled.candidate.places) {
      EXPECT_NEAR(place.position.head<2>().norm(), 1, 0.02);
      EXPECT_NEAR(std::abs(place.normal.dot(place.position.normalized())),
                  place.position.head<2>().norm() / place.position.norm(), 0.02);
    }
  }
}

TEST(RuledCandidates, CirclesThatRunTheOtherWay) {
  FaceDrawing drawing;
  drawing.AddShape(Arc({0, 0, 0}, 1, 2 * std::numbers::pi));
  CircularArc turned = Arc({0, 0, 1}, 1, 2 * std::numbers::pi);
  turned.x_axis = -Eigen::Vector3d::UnitY();
  turned.y_axis = -Eigen::Vector3d::UnitX();
  drawing.AddShape(turned);
  const auto candidates = CandidatesOf(drawing.graph());
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_NEAR(AreaOf(candidates[0].face), 2 * std::numbers::pi, 0.02);
  // Both rails run the same way.
  EXPECT_LT(candidates[0].face.loops[1][0].to, candidates[0].face.loops[1][0].from);
}

TEST(RuledCandidates, BetweenArcsThatLinesJoin) {
  const auto candidates = CandidatesOf(testing::HalfCylinderSide());
  ASSERT_EQ(candidates.size(), 1u);
  const DrawingFace& face = candidates[0].face;
  EXPECT_EQ(face.side_starts, (std::vector<int>{0, 1, 2, 3}));
  for (const FaceEdge& edge : face.loops[0]) EXPECT_FALSE(edge.IsBridge());
  EXPECT_NEAR(AreaOf(face), 2 * std::numbers::pi, 0.02);
}

TEST(RuledCandidates, MissingSidesOfArcsAreBridged) {
  FaceDrawing drawing;
  drawing.AddShape(Arc({0, 0, 0}, 1, std::numbers::pi));
  drawing.AddShape(Arc({0, 0, 1}, 1, std::numbers::pi));
  const auto candidates = CandidatesOf(drawing.graph());
  ASSERT_EQ(candidates.size(), 1u);
  const FaceLoop& loop = candidates[0].face.loops[0];
  EXPECT_TRUE(loop[1].IsBridge() && loop[3].IsBridge());
  EXPECT_NEAR((loop[1].bridge.front() - Eigen::Vector3d(-1, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((loop[1].bridge.back() - Eigen::Vector3d(-1, 0, 1)).norm(), 0, 1e-6);
  // Arcs that do not stand above each other.
  FaceDrawing shifted;
  shifted.AddShape(Arc({0, 0, 0}, 1, std::numbers::pi));
  shifted.AddShape(Arc({0, 0, 1}, 1, 0.7 * std::numbers::pi));
  EXPECT_TRUE(CandidatesOf(shifted.graph()).empty());
}

TEST(RuledCandidates, NoneInAPlane) {
  FaceDrawing drawing;
  drawing.AddShape(Arc({0, 0, 0}, 1, std::numbers::pi));
  drawing.AddShape(Arc({0, 0, 0}, 0.6, std::numbers::pi));
  drawing.AddLine({-1, 0, 0}, {-0.6, 0, 0});
  drawing.AddLine({1, 0, 0}, {0.6, 0, 0});
  EXPECT_TRUE(CandidatesOf(drawing.graph()).empty());
}

}  // namespace
}  // namespace limn
