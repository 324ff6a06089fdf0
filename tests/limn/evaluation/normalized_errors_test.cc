// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/normalized_errors.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "limn/model/footprint.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(8, 5);
  return views;
}

double Pixel() { return PixelFootprint(Views(), Eigen::Vector3d::Zero()); }

CurveSet AxisX(double z = 0) {
  CurveSet set;
  set.polylines = {{Eigen::Vector3d(-0.5, 0, z), Eigen::Vector3d(0.5, 0, z)}};
  return set;
}

// Vertices along the x axis with normal errors of this size across it, and their sigma.
DrawingGraph Noisy(double error, double sigma, const Eigen::Vector3d& offset = {0, 0, 0}) {
  std::mt19937 random(2);
  testing::NormalDistribution<double> gauss(0, 1);
  DrawingGraph graph;
  graph.links.resize(1);
  for (int i = 0; i < 4000; ++i) {
    const double y = error * gauss(random);
    const double z = error * gauss(random);
    graph.links[0].points_in_world.push_back(offset + Eigen::Vector3d(i / 4000.0 - 0.5, y, z));
    graph.links[0].sigma.push_back(sigma);
  }
  return graph;
}

NormalizedErrors Measure(const DrawingGraph& graph, const CurveSet& dont_care = {},
                         const NormalizedErrorOptions& options = {}) {
  return MeasureNormalizedErrors(graph, AxisX(), dont_care, Views(), options);
}

TEST(NormalizedErrors, AreOneWhereSigmasAreRight) {
  const NormalizedErrors errors = Measure(Noisy(0.2 * Pixel(), 0.2 * Pixel()));
  EXPECT_EQ(errors.num_inliers, 4000);
  EXPECT_EQ(errors.num_false, 0);
  EXPECT_NEAR(*errors.variance, 1, 0.06);
  EXPECT_NEAR(*errors.median_variance, 1, 0.08);
  EXPECT_EQ(*errors.variance_with_false, *errors.variance);
}

TEST(NormalizedErrors, GrowWithTheSquareOfWhatSigmasMiss) {
  const NormalizedErrors errors = Measure(Noisy(0.2 * Pixel(), 0.1 * Pixel()));
  EXPECT_NEAR(*errors.variance, 4, 0.24);
  EXPECT_NEAR(*errors.median_variance, 4, 0.32);
}

// Beyond the end of a true curve a vertex is no less exact across it.
TEST(NormalizedErrors, AlongTheTruthNothingCounts) {
  DrawingGraph graph;
  graph.links.resize(1);
  graph.links[0].points_in_world = {Eigen::Vector3d(0.5 + Pixel(), 0.1 * Pixel(), 0)};
  graph.links[0].sigma = {0.2 * Pixel()};
  EXPECT_NEAR(*Measure(graph).variance, 0.01 / (2 * 0.04), 1e-6);
}

TEST(NormalizedErrors, FalseVerticesCountApart) {
  DrawingGraph graph = Noisy(0, 0.5 * Pixel());
  const DrawingGraph off = Noisy(0, 0.5 * Pixel(), {0, 0, 5 * Pixel()});
  graph.links.push_back(off.links[0]);
  const NormalizedErrors errors = Measure(graph);
  EXPECT_EQ(errors.num_inliers, 4000);
  EXPECT_EQ(errors.num_false, 4000);
  EXPECT_NEAR(*errors.variance, 0, 1e-9);
  // A false vertex counts as one at the largest distance of 2 footprints: 4 / (2 * 0.25).
  EXPECT_NEAR(*errors.variance_with_false, 0.5 * 8, 0.1);
}

TEST(NormalizedErrors, NearDontCareCurvesNothingIsFalse) {
  const DrawingGraph graph = Noisy(0, 0.5 * Pixel(), {0, 0, 5 * Pixel()});
  const NormalizedErrors errors = Measure(graph, AxisX(6 * Pixel()));
  EXPECT_EQ(errors.num_false, 0);
  EXPECT_FALSE(errors.variance);
  EXPECT_FALSE(errors.median_variance);
}

TEST(NormalizedErrors, OnlyTheRegionAndKnownSigmasCount) {
  DrawingGraph graph = Noisy(0.2 * Pixel(), 0.2 * Pixel());
  NormalizedErrorOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0, -1, -1), Eigen::Vector3d(1, 1, 1));
  EXPECT_NEAR(Measure(graph, {}, options).num_inliers, 2000, 1);
  graph.links[0].sigma.assign(4000, std::numeric_limits<double>::infinity());
  EXPECT_EQ(Measure(graph).num_inliers, 0);
}

}  // namespace
}  // namespace limn
