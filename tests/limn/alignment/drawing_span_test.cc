// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/drawing_span.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

Eigen::Matrix3d Variances(double x, double y, double z) {
  return Eigen::Vector3d(x * x, y * y, z * z).asDiagonal();
}

class MeasureSpanTest : public ::testing::Test {
 protected:
  MeasureSpanTest() : graph_(testing::WireRoom()) {
    const DrawingLink& link = graph_.links[0];
    along_ = (link.points_in_world.back() - link.points_in_world.front()).normalized();
  }

  void SetCovariance(const Eigen::Matrix3d& covariance) {
    for (DrawingNode& node : graph_.nodes) node.covariance = covariance;
  }

  DrawingGraph graph_;
  Eigen::Vector3d along_;
};

TEST_F(MeasureSpanTest, OnlyWhatIsAlongTheLineBetweenBothPlacesCounts) {
  ASSERT_TRUE(along_.isApprox(Eigen::Vector3d::UnitX()) ||
              along_.isApprox(-Eigen::Vector3d::UnitX()));
  SetCovariance(Variances(0.03, 1, 2));
  const MeasuredLength measured = MeasureSpan(graph_, *ParseSpan("link 0"));
  EXPECT_DOUBLE_EQ(measured.length, 5);
  EXPECT_NEAR(measured.sigma, 0.03 * std::sqrt(2), 1e-12);
  EXPECT_NEAR(MeasureSpan(graph_, *ParseSpan("from 0 to 1")).sigma, measured.sigma, 1e-12);
}

TEST_F(MeasureSpanTest, IsUnknownWhereAPlaceIs) {
  SetCovariance(Variances(0.03, 1, 2));
  graph_.nodes[graph_.links[0].node1].covariance.setZero();
  EXPECT_EQ(MeasureSpan(graph_, *ParseSpan("link 0")).sigma, 0);
}

TEST_F(MeasureSpanTest, AClosedLinkGrowsWithItsRadius) {
  DrawingLink& link = graph_.links[0];
  link.closed = true;
  link.node1 = link.node0;
  link.sigma.assign(link.points_in_world.size(), 0.01);
  EXPECT_NEAR(MeasureSpan(graph_, *ParseSpan("link 0")).sigma, 0.02 * std::numbers::pi, 1e-12);
}

TEST_F(MeasureSpanTest, WhatTheDrawingDoesNotHaveIsAnError) {
  EXPECT_THROW(MeasureSpan(graph_, *ParseSpan("link 99")), InputError);
  EXPECT_THROW(MeasureSpan(graph_, *ParseSpan("from 0 to 99")), InputError);
  EXPECT_THROW(MeasureSpan(graph_, *ParseSpan("from 1 to 1")), InputError);
}

TEST_F(MeasureSpanTest, DimensionsAreBetweenNodesOrPointsOfLinks) {
  SetCovariance(Variances(0.03, 1, 2));
  const DrawingLink& link = graph_.links[0];
  const Eigen::Vector3d end = link.points_in_world.back(), middle = link.points_in_world[1];
  graph_.dimensions = {{link.points_in_world.front(), end, {0, 0, 0}}, {middle, end, {0, 0, 0}}};
  Alignment alignment;
  alignment.world_from_model.scale = 2;
  alignment.scale = ScaleSource::kLengths;
  alignment.scale_sigma = 0.01;
  MeasureDimensions(alignment, &graph_);
  EXPECT_NEAR(graph_.dimensions[0].sigma, std::hypot(0.03 * std::sqrt(2), 0.05), 1e-12);
  const double of_middle = link.sigma[1];
  EXPECT_NEAR(graph_.dimensions[1].sigma, std::hypot(0.03, of_middle, 0.025), 1e-12);
}

TEST(InWorldTest, TheScaleAddsItsShare) {
  Alignment alignment;
  alignment.world_from_model.scale = 2;
  alignment.scale = ScaleSource::kLengths;
  alignment.scale_sigma = 0.01;
  const MeasuredLength measured = InWorld({5, 0.02}, alignment);
  EXPECT_DOUBLE_EQ(measured.length, 10);
  EXPECT_NEAR(measured.sigma, std::hypot(0.04, 0.1), 1e-12);
  EXPECT_EQ(InWorld({5, 0}, alignment).sigma, 0);
  // Of a scale from elsewhere nobody knows how good it is.
  alignment.scale_sigma = 0;
  EXPECT_EQ(InWorld({5, 0.02}, alignment).sigma, 0);
}

}  // namespace
}  // namespace limn
