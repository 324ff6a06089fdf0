// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_transform.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/primitive_drawing.h"
#include "limn/geometry/polyline.h"

namespace limn {
namespace {

TEST(ZUpFrom, TakesTheAxisToZAndIsARotation) {
  const std::array<std::pair<SignedAxis, Eigen::Vector3d>, 6> cases = {
      {{SignedAxis::kX, {1, 0, 0}},
       {SignedAxis::kY, {0, 1, 0}},
       {SignedAxis::kZ, {0, 0, 1}},
       {SignedAxis::kMinusX, {-1, 0, 0}},
       {SignedAxis::kMinusY, {0, -1, 0}},
       {SignedAxis::kMinusZ, {0, 0, -1}}}};
  for (const auto& [axis, up] : cases) {
    const Eigen::Matrix3d rotation = ZUpFrom(axis);
    EXPECT_EQ(rotation * up, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(rotation.determinant(), 1);
    EXPECT_EQ(rotation * rotation.transpose(), Eigen::Matrix3d::Identity());
  }
  EXPECT_EQ(ZUpFrom(SignedAxis::kZ), Eigen::Matrix3d::Identity());
  EXPECT_EQ(ZUpFrom(SignedAxis::kMinusY) * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 3, -2));
}

TEST(TransformedDrawing, MovesGraphAndPrimitivesAlike) {
  const DrawingGraph graph = PrimitiveDrawing();
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d translation(5, -7, 100);
  const double scale = 2.5;
  const DrawingGraph moved = Transformed(graph, scale, rotation, translation);
  EXPECT_THAT(Validate(moved), ::testing::IsEmpty());
  ASSERT_EQ(moved.links.size(), graph.links.size());
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    EXPECT_NEAR(Length(moved.links[l].points_in_world), scale * Length(link.points_in_world), 1e-9);
    EXPECT_EQ(moved.links[l].sigma[0], scale * link.sigma[0]);
    EXPECT_EQ(moved.links[l].residual_px, link.residual_px);
    ASSERT_EQ(moved.links[l].primitive.has_value(), link.primitive.has_value());
    if (!link.primitive) continue;
    EXPECT_EQ(moved.links[l].primitive->rms_px, link.primitive->rms_px);
    for (const double t : {0.0, 0.3, 0.8, 1.0}) {
      const Eigen::Vector3d expected =
          scale * (rotation * PointAt(link.primitive->shape, t)) + translation;
      EXPECT_LT((PointAt(moved.links[l].primitive->shape, t) - expected).norm(), 1e-12 * 100);
    }
  }
}

TEST(TransformedDrawing, BodiesMoveAlong) {
  DrawingGraph graph = PrimitiveDrawing();
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 1;
  graph.links[0].body = {RoundShape::kCone, {1, 0, 0}, {1, 0, 2}, 0.5, 0.25, 0.125, 0.75};
  graph.links[0].depth_sigma = 0.5;
  const DrawingGraph moved = Transformed(graph, 2, ZUpFrom(SignedAxis::kX), {0, 0, 10});
  EXPECT_THAT(Validate(moved), ::testing::IsEmpty());
  const RoundBody expected = {RoundShape::kCone, {0, 0, 12}, {0, 4, 12}, 1, 0.5, 0.25, 0.75};
  EXPECT_EQ(moved.links[0].body, expected);
  EXPECT_EQ(moved.links[0].depth_sigma, 1);
  EXPECT_EQ(moved.links[1].depth_sigma, -1);
}

TEST(TransformedDrawing, RegularitiesMoveAlong) {
  DrawingGraph graph;
  const Eigen::Vector3d on_plane(1, 2, 3), normal = Eigen::Vector3d(1, 1, 0).normalized();
  graph.regularities = {
      {{normal, {}}}, {{normal, normal.dot(on_plane), 0}}, {2}, {{on_plane, normal}}};
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(2, 1, 1).normalized()).toRotationMatrix();
  const Eigen::Vector3d translation(5, -7, 10);
  const Regularities moved = Transformed(graph, 2.5, rotation, translation).regularities;
  const Eigen::Vector3d place = 2.5 * (rotation * on_plane) + translation;
  EXPECT_LT((moved.directions[0].direction - rotation * normal).norm(), 1e-12);
  EXPECT_NEAR(moved.planes[0].normal.dot(place), moved.planes[0].offset, 1e-12);
  EXPECT_EQ(moved.radii[0], 5);
  EXPECT_LT((moved.axes[0].point - place).norm(), 1e-12);
}

TEST(TransformedDrawing, AnAxisChangeLosesNoBit) {
  const DrawingGraph graph = PrimitiveDrawing();
  const DrawingGraph there =
      Transformed(graph, 1, ZUpFrom(SignedAxis::kMinusY), Eigen::Vector3d::Zero());
  const DrawingGraph back =
      Transformed(there, 1, ZUpFrom(SignedAxis::kMinusY).transpose(), Eigen::Vector3d::Zero());
  for (size_t l = 0; l < graph.links.size(); ++l) {
    EXPECT_EQ(back.links[l].points_in_world, graph.links[l].points_in_world);
  }
  EXPECT_NE(there.links[0].points_in_world, graph.links[0].points_in_world);
}

// Numbers that run over or vanish do not go into files.
TEST(TransformedDrawing, ScalesThatBreakItAreSeenByValidate) {
  for (const double scale : {1e308, 1e-323}) {
    const DrawingGraph moved = Transformed(PrimitiveDrawing(), scale, Eigen::Matrix3d::Identity(),
                                           Eigen::Vector3d::Zero());
    EXPECT_THAT(Validate(moved), ::testing::Not(::testing::IsEmpty())) << scale;
  }
}

}  // namespace
}  // namespace limn
