// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/curve_averaging.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Rows of samples along x at these offsets, a pixel apart, without overlaps. Footprint 1: a unit is
// a pixel.
struct AveragingScene {
  static constexpr int kSize = 30;

  explicit AveragingScene(const std::vector<Vector3d>& offsets) {
    std::vector<std::vector<Vector3d>> rows;
    for (const Vector3d& offset : offsets) rows.push_back(testing::Row(offset, {1, 0, 0}, kSize));
    samples = testing::MakeSamples(rows);
    network.overlaps.resize(offsets.size());
  }

  // Each sample of `curve` corresponds to that of the same number of `other`, `shift` further on.
  void Overlap(int curve, int other, int shift = 0) {
    CurveOverlap overlap;
    overlap.other = other;
    for (int k = 0; k < samples.Size(curve); ++k) {
      const int partner = std::clamp(k + shift, 0, samples.Size(other) - 1);
      overlap.partner.push_back(samples.curve_begin[other] + partner);
    }
    network.overlaps[curve].push_back(overlap);
  }

  void OverlapBoth(int a, int b) {
    Overlap(a, b);
    Overlap(b, a);
  }

  void SetInformation(int curve, const Matrix3d& information) {
    for (int s = samples.curve_begin[curve]; s < samples.curve_begin[curve + 1]; ++s) {
      samples.information[s] = information;
    }
  }

  AveragingResult Average() { return AverageCurves(network, options, {}, &samples); }

  Vector3d At(int curve, int k) const { return samples.position[samples.curve_begin[curve] + k]; }

  SampleSet samples;
  CurveConsistency network;
  PaperOptions options;
};

// All samples of a row are at this offset, and have not moved along it. Its ends are not asked: at
// them, the feet on the other rows are just at an end.
void ExpectRow(const AveragingScene& scene, int curve, const Vector3d& offset, double tolerance) {
  for (int k = 1; k + 1 < AveragingScene::kSize; ++k) {
    EXPECT_LT((scene.At(curve, k) - offset - Vector3d(k, 0, 0)).norm(), tolerance)
        << "curve " << curve << " sample " << k << " at " << scene.At(curve, k).transpose();
  }
}

TEST(CurveAveragingTest, EqualCurvesMeetInTheMiddle) {
  AveragingScene scene({{0, 0, 0}, {0, 0.3, -0.4}});
  scene.OverlapBoth(0, 1);
  const SampleSet before = scene.samples;
  EXPECT_EQ(scene.Average().rounds, 2);  // the second moves nothing
  ExpectRow(scene, 0, {0, 0.15, -0.2}, 1e-6);
  ExpectRow(scene, 1, {0, 0.15, -0.2}, 1e-6);
  EXPECT_EQ(scene.samples.tangent, before.tangent);
  EXPECT_EQ(scene.samples.information, before.information);
  EXPECT_EQ(scene.samples.footprint, before.footprint);
}

TEST(CurveAveragingTest, ClosestPointIsSoughtBesideThePartner) {
  for (const int shift : {-4, 4}) {
    AveragingScene scene({{0, 0, 0}, {0, 0.4, 0}});
    scene.Overlap(0, 1, shift);
    scene.options.max_averaging_rounds = 1;
    scene.Average();
    ExpectRow(scene, 0, {0, 0.2, 0}, 1e-6);
  }
}

TEST(CurveAveragingTest, SamplesWithoutPartnersStay) {
  AveragingScene scene({{0, 0, 0}, {0, 0.4, 0}, {0, -0.2, 0}});
  scene.OverlapBoth(0, 1);
  std::vector<int>& partner = scene.network.overlaps[0][0].partner;
  std::fill(partner.begin(), partner.begin() + 10, -1);
  const SampleSet before = scene.samples;
  scene.options.max_averaging_rounds = 1;
  scene.Average();
  for (int k = 1; k + 1 < AveragingScene::kSize; ++k) {
    EXPECT_NEAR(scene.At(0, k).y(), k < 10 ? 0 : 0.2, 1e-6);
    EXPECT_NEAR(scene.At(1, k).y(), 0.2, 1e-6);
    EXPECT_EQ(scene.At(2, k),
              before.position[2 * AveragingScene::kSize + k]);  // no overlaps at all
  }
}

// The other curve runs from sample 10 to sample 19 of the first; samples beyond have its ends as
// partners, near enough to pull.
TEST(CurveAveragingTest, FeetBeyondTheEndDoNotPull) {
  AveragingScene scene({{0, 0, 0}});
  scene.samples = testing::MakeSamples({testing::Row({0, 0, 0}, {1, 0, 0}, AveragingScene::kSize),
                                        testing::Row({10, 0.4, 0}, {1, 0, 0}, 10)});
  scene.network.overlaps.resize(2);
  scene.Overlap(0, 1, -10);
  scene.options.max_averaging_rounds = 1;
  scene.Average();
  for (int k = 0; k < AveragingScene::kSize; ++k) {
    if (k == 10 || k == 19) continue;  // just at the end
    EXPECT_NEAR(scene.At(0, k).y(), k < 10 || k > 19 ? 0 : 0.2, 1e-9) << k;
  }
}

// A circle of 60 samples, and one sample half a pixel outside, half-way between its last sample and
// its first.
double PullAtTheSeam(bool closed, int partner) {
  const int count = 60;
  const double radius = count / (2 * M_PI);
  std::vector<Vector3d> circle;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * (k + 0.5) / count;
    circle.push_back(radius * Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  const std::vector<Vector3d> outside = testing::Row({radius + 0.5, -1, 0}, {0, 1, 0}, 3);
  AveragingScene scene({{0, 0, 0}});
  scene.samples = testing::MakeSamples({circle, outside});
  scene.samples.origins[0].closed = closed;
  scene.network.overlaps = {{}, {{0, {-1, partner, -1}}}};
  scene.options.max_averaging_rounds = 1;
  scene.Average();
  return radius + 0.5 - scene.At(1, 1).x();
}

TEST(CurveAveragingTest, ClosedCurvesHaveNoEndToBeBeyond) {
  for (const int partner : {0, 59}) {
    EXPECT_NEAR(PullAtTheSeam(true, partner), 0.25, 0.02);  // half-way to the ends
    EXPECT_EQ(PullAtTheSeam(false, partner), 0);
  }
}

// All curves count the same, however far, and whatever their information.
TEST(CurveAveragingTest, AllCurvesCountTheSame) {
  AveragingScene scene({{0, 0, 0}, {0, 3, 0}, {0, 0, 6}});
  scene.SetInformation(1, Vector3d(0, 4, 400).asDiagonal());
  for (const int other : {1, 2}) scene.Overlap(0, other);
  scene.options.max_averaging_rounds = 1;
  scene.Average();
  ExpectRow(scene, 0, {0, 1, 2}, 1e-9);
  ExpectRow(scene, 1, {0, 3, 0}, 1e-9);
}

// The partner is 20 samples off.
TEST(CurveAveragingTest, ClosestPointsAreSoughtAnew) {
  AveragingScene scene({{0, 0, 0}, {0, 1, 0}});
  scene.Overlap(0, 1, 20);
  scene.options.max_averaging_rounds = 200;
  EXPECT_TRUE(scene.Average().converged);
  ExpectRow(scene, 0, {0, scene.At(0, 5).y(), 0}, 1e-9);
  EXPECT_NEAR(scene.At(0, 5).y(), 1, scene.options.averaging_tolerance_px);
}

// A sample that has moved by no more than the tolerance rests, even if it is pulled later.
TEST(CurveAveragingTest, WhatRestsStays) {
  AveragingScene scene({{0, 0, 0}, {0, 1, 0}, {0, 1.02, 0}});
  scene.OverlapBoth(0, 1);
  scene.OverlapBoth(1, 2);
  scene.options.averaging_tolerance_px = 0.02;
  scene.options.max_averaging_rounds = 500;
  EXPECT_TRUE(scene.Average().converged);
  ExpectRow(scene, 2, {0, 1.02 - 0.01, 0}, 1e-9);
}

// Five copies of a line with noise of 0.15 px, each overlapping all others.
AveragingScene NoisyCopies() {
  AveragingScene scene(std::vector<Vector3d>(5, Vector3d::Zero()));
  std::mt19937 random(11);
  testing::NormalDistribution<double> gauss(0, 0.15);
  for (Vector3d& position : scene.samples.position) {
    position.y() += gauss(random);
    position.z() += gauss(random);
  }
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) {
      if (a != b) scene.Overlap(a, b);
    }
  }
  return scene;
}

TEST(CurveAveragingTest, EndsWhenNoSampleMovesByMoreThanTheTolerance) {
  int last_rounds = 0;
  for (const double tolerance_px : {1.0, 0.05, 0.005}) {
    AveragingScene scene = NoisyCopies();
    scene.options.averaging_tolerance_px = tolerance_px;
    scene.options.max_averaging_rounds = 300;
    const AveragingResult result = scene.Average();
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.last_move_px, tolerance_px);
    EXPECT_LT(result.rounds, 300);
    EXPECT_GT(result.rounds, last_rounds);
    last_rounds = result.rounds;
  }
}

TEST(CurveAveragingTest, NoiseIsAveraged) {
  AveragingScene scene = NoisyCopies();
  scene.Average();
  double sum = 0;
  for (const Vector3d& position : scene.samples.position) sum += position.tail<2>().squaredNorm();
  // The mean of five: 0.15 px / sqrt(5) in either direction, 30 % for the chance of 30 samples.
  EXPECT_LT(std::sqrt(sum / (2 * scene.samples.NumSamples())), 1.3 * 0.15 / std::sqrt(5.0));
}

// The tolerance is in footprints, too.
TEST(CurveAveragingTest, ToleranceIsInFootprints) {
  for (const double footprint : {0.01, 100.0}) {
    AveragingScene scene({{0, 0, 0}, {0, 0.4 * footprint, 0}});
    scene.samples.footprint.assign(scene.samples.footprint.size(), footprint);
    for (Matrix3d& information : scene.samples.information) information /= footprint * footprint;
    scene.OverlapBoth(0, 1);
    EXPECT_EQ(scene.Average().rounds, 2);
  }
}

// The last movement, too, is in footprints.
TEST(CurveAveragingTest, LastMovementIsThatOfTheSampleThatMovedFarthest) {
  const double footprint = 5;
  AveragingScene scene(
      {{0, 0, 0}, {0, 0.4 * footprint, 0}, {0, 40, 0}, {0, 40 + 0.2 * footprint, 0}});
  scene.samples.footprint.assign(scene.samples.footprint.size(), footprint);
  for (Matrix3d& information : scene.samples.information) information /= footprint * footprint;
  scene.OverlapBoth(0, 1);
  scene.OverlapBoth(2, 3);
  scene.options.max_averaging_rounds = 1;
  const AveragingResult result = scene.Average();
  EXPECT_NEAR(result.last_move_px, 0.2, 1e-6);
  EXPECT_FALSE(result.converged);
}

// Three rows, the middle one overlaps both: in every round, the outer ones come half as near.
TEST(CurveAveragingTest, RoundsAreCountedAndLimited) {
  for (const int rounds : {0, 1, 2, 5}) {
    AveragingScene scene({{0, -0.3, 0}, {0, 0, 0}, {0, 0.3, 0}});
    scene.OverlapBoth(0, 1);
    scene.OverlapBoth(1, 2);
    scene.options.averaging_tolerance_px = 1e-9;
    scene.options.max_averaging_rounds = rounds;
    const AveragingResult result = scene.Average();
    EXPECT_EQ(result.rounds, rounds);
    EXPECT_FALSE(result.converged);
    const double offset = 0.3 * std::pow(0.5, rounds);
    // In the last round they came half as near, that is, by as much as is left.
    EXPECT_NEAR(result.last_move_px, rounds == 0 ? 0 : offset, 1e-6);
    ExpectRow(scene, 0, {0, -offset, 0}, 1e-6);
    ExpectRow(scene, 1, {0, 0, 0}, 1e-6);
    ExpectRow(scene, 2, {0, offset, 0}, 1e-6);
  }
}

TEST(CurveAveragingTest, NothingTakesNoRound) {
  AveragingScene none({});
  const AveragingResult result = none.Average();
  EXPECT_EQ(result.rounds, 0);
  EXPECT_TRUE(result.converged);
}

}  // namespace
}  // namespace limn
