// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/consensus.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/drawing/noisy_samples.h"
#include "limn/geometry/angle_between.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::CircleAround;
using testing::LineBetween;
using testing::SampleMaker;
using testing::SampleNoise;

constexpr int kNumViews = 8;
// Samples within the standard deviation of the weights along the curve, at its end, where there are
// some on one side only. A mean of this many has at least this error.
constexpr int kNumNear = kNumViews * 5 / 2;
// What Gaussian errors of some hundred samples do not exceed.
constexpr double kSigmas = 5;

double LargestError(double noise) { return kSigmas * noise / std::sqrt(kNumNear); }

Consensus Find(const SampleSet& samples, int num_threads = 2) {
  RunContext context;
  context.num_threads = num_threads;
  return FindConsensus(samples, ReprojectedMetric(samples), context);
}

SampleSet NoisyLine(double footprint = 1) {
  SampleMaker maker(footprint);
  maker.AddInViews(LineBetween({0, 0, 0}, {40, 20, 40}), 0, kNumViews, {0.3, 0.3, 3 * kDeg});
  return maker.samples();
}

TEST(OffsetBetweenTest, PointsOfOneCircleHaveNoneAcross) {
  const auto circle = CircleAround({3, 4, 5}, 10);
  for (const double arc : {-4.0, -1.0, 0.5, 4.0}) {
    const OffsetAlong offset =
        OffsetBetween(circle.at(arc) - circle.at(0), circle.Tangent(0), circle.Tangent(arc));
    EXPECT_LT(offset.across.norm(), 1e-6);
    EXPECT_NEAR(offset.along, 10 * std::sin(arc / 10), 1e-6);
  }
}

TEST(OffsetBetweenTest, ParallelLinesHaveTheirDistance) {
  const Vector3d tangent = Vector3d(1, 2, 2) / 3;
  const Vector3d across = 0.7 * Vector3d(2, 1, -2) / 3;
  const OffsetAlong offset = OffsetBetween(5 * tangent + across, tangent, tangent);
  EXPECT_NEAR(offset.along, 5, 1e-12);
  EXPECT_LT((offset.across - across).norm(), 1e-12);
}

TEST(ReprojectedMetricTest, CountsPxAndWeaklyDeterminedDirectionsLess) {
  SampleMaker maker(0.02);
  maker.Add(LineBetween({0, 0, 0}, {5, 0, 0}), 0, {0.1, 0.5, 0});
  const ReprojectedMetric metric(maker.samples());
  EXPECT_NEAR(metric.Squared(2, {0, 0.02, 0}), 1, 1e-9);
  EXPECT_NEAR(metric.Squared(2, {0, 0, 0.02}), 1.0 / 25, 1e-9);
  EXPECT_NEAR(metric.Squared(2, {0.02, 0, 0}), 0, 1e-9);
}

TEST(ReprojectedMetricTest, CountsAllDirectionsAcrossAlikeWithoutInformation) {
  SampleMaker maker(0.02);
  maker.Add(LineBetween({0, 0, 0}, {5, 0, 0}), 0);
  SampleSet samples = maker.samples();
  samples.information[0].setZero();
  const ReprojectedMetric metric(samples);
  EXPECT_NEAR(metric.Squared(0, {0.02, 0.04, 0}), 4, 1e-9);
  EXPECT_NEAR(metric.Squared(0, {0.02, 0, 0.04}), 4, 1e-9);
}

TEST(ConsensusTest, NothingGivesNothing) { EXPECT_TRUE(Find(SampleSet()).position.empty()); }

TEST(ConsensusTest, SamplesOfAllViewsClimbToTheLine) {
  const SampleSet samples = NoisyLine();
  const Vector3d direction = Vector3d(2, 1, 2) / 3;
  const Consensus consensus = Find(samples);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const Vector3d& position = consensus.position[s];
    EXPECT_LT((position - position.dot(direction) * direction).norm(), LargestError(0.3));
    EXPECT_LT(AngleBetween(consensus.tangent[s], direction), LargestError(3 * kDeg));
    // They do not move along it.
    EXPECT_NEAR((position - samples.position[s]).dot(direction), 0, 0.3);
  }
}

TEST(ConsensusTest, CirclesKeepTheirRadius) {
  const double radius = 12;
  const double noise = 0.2;
  SampleMaker maker;
  maker.AddInViews(CircleAround({0, 0, 0}, radius), 0, kNumViews, SampleNoise::Even(noise));
  const Consensus consensus = Find(maker.samples());
  double mean = 0;
  for (const Vector3d& position : consensus.position) {
    EXPECT_LT(std::hypot(position.head<2>().norm() - radius, position.z()), LargestError(noise));
    mean += (position.head<2>().norm() - radius) / maker.samples().NumSamples();
  }
  // The sagitta within the reach of the weights along the curve, 2.5 px, is .26 px.
  EXPECT_LT(std::abs(mean), kSigmas * noise / std::sqrt(maker.samples().NumSamples()));
}

TEST(ConsensusTest, WeaklyDeterminedDepthsAgree) {
  const double depth_noise = 2;
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, kNumViews, {0.1, depth_noise, 0});
  const Consensus consensus = Find(maker.samples());
  double sum = 0;
  for (const Vector3d& position : consensus.position) {
    EXPECT_LT(std::abs(position.y()), LargestError(0.1));
    sum += position.z() * position.z();
  }
  EXPECT_LT(std::sqrt(sum / maker.samples().NumSamples()), 2 * depth_noise / std::sqrt(kNumNear));
}

TEST(ConsensusTest, LinesTwoAndAHalfPxApartStayTwo) {
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, kNumViews, SampleNoise::Even(0.2));
  const int num_first = maker.samples().NumSamples();
  maker.AddInViews(LineBetween({0, 2.5, 0}, {60, 2.5, 0}), 0, kNumViews, SampleNoise::Even(0.2));
  const Consensus consensus = Find(maker.samples());
  for (int s = 0; s < maker.samples().NumSamples(); ++s) {
    const double own = s < num_first ? 0 : 2.5;
    EXPECT_LT(std::abs(consensus.position[s].y() - own), LargestError(0.2));
  }
}

TEST(ConsensusTest, LinesHalfAPxApartBecomeOneBetweenThem) {
  const double noise = 0.1;
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, kNumViews / 2, SampleNoise::Even(noise));
  maker.AddInViews(LineBetween({0, 0.5, 0}, {60, 0.5, 0}), kNumViews / 2, kNumViews,
                   SampleNoise::Even(noise));
  const Consensus consensus = Find(maker.samples());
  for (int s = 0; s < maker.samples().NumSamples(); ++s) {
    EXPECT_LT(std::abs(consensus.position[s].y() - 0.25), LargestError(noise));
    EXPECT_EQ(consensus.num_views[s], kNumViews);
  }
}

TEST(ConsensusTest, CrossingLinesDoNotMoveEachOther) {
  SampleMaker maker;
  maker.AddInViews(LineBetween({-30, 0, 0}, {30, 0, 0}), 0, 3);
  const int num_first = maker.samples().NumSamples();
  const double angle = 30 * kDeg;
  const Vector3d direction(std::cos(angle), std::sin(angle), 0);
  maker.AddInViews(LineBetween(-30 * direction, 30 * direction), 0, 3);
  const Consensus consensus = Find(maker.samples());
  for (int s = 0; s < maker.samples().NumSamples(); ++s) {
    const Vector3d& along = s < num_first ? Vector3d::UnitX() : direction;
    EXPECT_LT(consensus.position[s].cross(along).norm(), 1e-6);
    EXPECT_LT(AngleBetween(consensus.tangent[s], along), 1e-6);
  }
}

TEST(ConsensusTest, CountsEachPrimaryViewOnce) {
  SampleMaker maker;
  maker.AddInViews(LineBetween({0, 0, 0}, {60, 0, 0}), 0, 3);
  maker.Add(LineBetween({0, 0, 0}, {60, 0, 0}), 1);   // a second curve of one of them
  maker.Add(LineBetween({30, 0, 0}, {60, 0, 0}), 7);  // half of it
  maker.Add(LineBetween({0, 2, 0}, {60, 2, 0}), 8);   // beside it
  const SampleSet& samples = maker.samples();
  const Consensus consensus = Find(samples);
  const int beside = samples.NumCurves() - 1;
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const double x = consensus.position[s].x();
    if (samples.curve_of[s] == beside) {
      EXPECT_EQ(consensus.num_views[s], 1) << x;
    } else if (std::abs(x - 30) > 2) {
      EXPECT_EQ(consensus.num_views[s], x < 30 ? 3 : 4) << x;
    }
  }
}

TEST(ConsensusTest, CurvesOfOppositeDirectionsAgree) {
  const SampleSet samples = NoisyLine();
  SampleSet reversed = samples;
  for (int s = 0; s < samples.NumSamples(); ++s) {
    if (samples.curve_of[s] % 2 == 1) reversed.tangent[s] *= -1;
  }
  const Consensus consensus = Find(samples);
  const Consensus same = Find(reversed);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    EXPECT_LT((same.position[s] - consensus.position[s]).norm(), 1e-9);
    const double sign = samples.curve_of[s] % 2 == 1 ? -1 : 1;
    EXPECT_LT((sign * same.tangent[s] - consensus.tangent[s]).norm(), 1e-9);
  }
  EXPECT_EQ(same.num_views, consensus.num_views);
}

TEST(ConsensusTest, ResultDoesNotDependOnThreads) {
  const SampleSet samples = NoisyLine();
  const Consensus one = Find(samples, 1);
  const Consensus three = Find(samples, 3);
  EXPECT_EQ(one.position, three.position);
  EXPECT_EQ(one.tangent, three.tangent);
  EXPECT_EQ(one.num_views, three.num_views);
}

TEST(ConsensusTest, ScaledSamplesGiveTheScaledConsensus) {
  const Consensus consensus = Find(NoisyLine());
  for (const double scale : {1e-6, 1e6}) {
    const Consensus scaled = Find(NoisyLine(scale));
    ASSERT_EQ(scaled.position.size(), consensus.position.size());
    for (size_t s = 0; s < consensus.position.size(); ++s) {
      EXPECT_LT((scaled.position[s] / scale - consensus.position[s]).norm(), 1e-6);
    }
    EXPECT_EQ(scaled.num_views, consensus.num_views);
  }
}

}  // namespace
}  // namespace limn
