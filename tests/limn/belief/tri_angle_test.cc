// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/tri_angle.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::LookAt;

// Of a line along y through the origin.
double AngleOfLine(const std::vector<Eigen::Vector3d>& centers) {
  std::vector<View> views;
  for (const Eigen::Vector3d& center : centers) views.push_back(LookAt(center, {0, 0, 0}));
  std::vector<ViewId> all(views.size());
  std::iota(all.begin(), all.end(), 0);
  DrawingGraph graph;
  DrawLink({{0, -1, 0}, {0, 0, 0}, {0, 1, 0}}, all, &graph);
  MeasureDepth(views, {}, &graph);
  EXPECT_EQ(graph.links[0].tri_angle_deg, TriAngleDeg(graph.links[0], views));
  return graph.links[0].tri_angle_deg;
}

TEST(TriAngleTest, TheLargestAngleBetweenTwoViews) {
  // Rays to places beside the middle are nearer to each other.
  EXPECT_NEAR(AngleOfLine({{0, 0, -5}, {5, 0, -5}}), 45, 0.2);
  EXPECT_NEAR(AngleOfLine({{0, 0, -5}, {1, 0, -5}, {5, 0, -5}, {2, 0, -5}}), 45, 0.2);
}

TEST(TriAngleTest, MotionAlongTheCurveAddsNothing) {
  EXPECT_NEAR(AngleOfLine({{0, -2, -5}, {0, 4, -5}}), 0, 1e-5);
  EXPECT_NEAR(AngleOfLine({{0, -2, -5}, {5, 4, -5}}), 45, 1e-9);
}

TEST(TriAngleTest, OppositeViewsSeeTheSamePlane) {
  EXPECT_NEAR(AngleOfLine({{0, 0, -5}, {0, 0, 5}}), 0, 1e-5);
  EXPECT_NEAR(AngleOfLine({{0, 0, -5}, {1, 0, 1}}), 45, 1e-9);
}

TEST(TriAngleTest, AViewAlongTheCurveTellsNothing) {
  EXPECT_NEAR(AngleOfLine({{0, 0, -5}, {0.01, 30, 0}}), 0, 1e-5);
}

// 20 degrees from the rays: their planes turn by 5.6 degrees where the camera moves by 2.
TEST(TriAngleTest, ACurveThatPointsAtTheCamerasTellsNoMoreThanRays) {
  const double tilt = 20 * kDeg;
  const Eigen::Vector3d center(0, -5 * std::cos(tilt), -5 * std::sin(tilt));
  const Eigen::Vector3d moved = center + Eigen::Vector3d(5 * std::tan(2 * kDeg), 0, 0);
  EXPECT_NEAR(AngleOfLine({center, moved}), 2, 0.25);
}

// Of a line along y through the origin with a standard deviation of 1 in the mean of both
// directions.
double DepthSigmaOfLine(double half_angle_deg) {
  const double x = 5 * std::tan(half_angle_deg * kDeg);
  const std::vector<View> views = {LookAt({x, 0, -5}, {0, 0, 0}), LookAt({-x, 0, -5}, {0, 0, 0})};
  DrawingGraph graph;
  DrawLink({{0, -1, 0}, {0, 0, 0}, {0, 1, 0}}, {0, 1}, &graph);
  graph.links[0].sigma = {1, 1, 1};
  return DepthSigma(graph.links[0], views);
}

// The variances along and across the rays are as cot^2 of half the angle between them.
TEST(DepthSigmaTest, ASmallAngleBetweenViewsIsAllInDepth) {
  const double ratio = std::pow(std::tan(10 * kDeg), -2);
  EXPECT_NEAR(DepthSigmaOfLine(10), std::sqrt(2 * ratio / (1 + ratio)), 0.01);
  EXPECT_NEAR(DepthSigmaOfLine(45), 1, 0.01);
}

TEST(DepthSigmaTest, UnknownWithoutSigmas) {
  DrawingGraph graph;
  DrawLink({{0, -1, 0}, {0, 1, 0}}, {0, 1}, &graph);
  const std::vector<View> views = {LookAt({0, 0, -5}, {0, 0, 0}), LookAt({2, 0, -5}, {0, 0, 0})};
  DrawingLink& link = graph.links[0];
  link.sigma.assign(2, 1);
  EXPECT_GT(DepthSigma(link, views), 0);
  link.sigma.assign(2, std::numeric_limits<double>::infinity());
  EXPECT_EQ(DepthSigma(link, views), -1);
}

TEST(DepthSigmaTest, UnknownOfContoursAndOfOneView) {
  DrawingGraph graph;
  DrawLink({{0, -1, 0}, {0, 1, 0}}, {0, 1}, &graph);
  const std::vector<View> views = {LookAt({0, 0, -5}, {0, 0, 0}), LookAt({2, 0, -5}, {0, 0, 0})};
  DrawingLink link = graph.links[0];
  link.sigma.assign(2, 1);
  link.kind = LinkKind::kContour;
  EXPECT_EQ(DepthSigma(link, views), -1);
  link.kind = LinkKind::kEdge;
  link.supporting_views = {1};
  EXPECT_EQ(DepthSigma(link, views), -1);
}

// The second of three views is far away, and says little.
TEST(DepthSigmaTest, NearViewsTellMore) {
  const Eigen::Vector3d middle(0, 0, -5), aside(5, 0, 0), far_aside(500, 0, 0);
  const auto sigma_with = [&](const Eigen::Vector3d& third) {
    const std::vector<View> views = {LookAt(middle, {0, 0, 0}), LookAt({0.5, 0, -5}, {0, 0, 0}),
                                     LookAt(third, {0, 0, 0})};
    DrawingGraph graph;
    DrawLink({{0, -1, 0}, {0, 1, 0}}, {0, 1, 2}, &graph);
    graph.links[0].sigma.assign(2, 1);
    return DepthSigma(graph.links[0], views);
  };
  EXPECT_GT(sigma_with(far_aside), 1.2 * sigma_with(aside));
}

TEST(TriAngleTest, OneViewIsUnknown) { EXPECT_EQ(AngleOfLine({{0, 0, -5}}), -1); }

}  // namespace
}  // namespace limn
