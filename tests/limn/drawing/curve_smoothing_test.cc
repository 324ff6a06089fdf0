// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/curve_smoothing.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/sample_curves.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using Eigen::Vector3d;
constexpr double kFootprint = 0.01;

std::vector<Vector3d> CirclePoints(int count, double radius_px) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    points.push_back(radius_px * kFootprint * Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

std::vector<Vector3d> LinePoints(int count) {
  return testing::Row({3, -2, 5}, kFootprint * Vector3d(2, -1, 2).normalized(), count);
}

// Smooth with data that are good to 0.2 px across the curve.
std::vector<Vector3d> Smooth(const std::vector<Vector3d>& points, bool closed) {
  SampleSet samples = testing::MakeSamples({points});
  if (closed) {
    samples.origins[0].closed = true;
    testing::RecomputeTangents(samples, 0, &samples.tangent);
  }
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const Vector3d& t = samples.tangent[s];
    samples.information[s] =
        (Eigen::Matrix3d::Identity() - t * t.transpose()) / std::pow(0.2 * kFootprint, 2);
    samples.footprint[s] = kFootprint;
  }
  return SmoothCurve(samples, closed, DrawingOptions().bending_sigma_px);
}

// Gaussian noise of 0.2 px in all directions.
std::vector<Vector3d> Noisy(std::vector<Vector3d> points) {
  std::mt19937 random(7);
  testing::NormalDistribution<double> gauss(0, 0.2 * kFootprint);
  for (Vector3d& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] += gauss(random);
  }
  return points;
}

double LineErrorPx(const Vector3d& point) {
  const Vector3d direction = Vector3d(2, -1, 2).normalized();
  return (point - Vector3d(3, -2, 5)).cross(direction).norm() / kFootprint;
}

double CircleErrorPx(const Vector3d& point, double radius_px) {
  return std::hypot(point.head<2>().norm() - radius_px * kFootprint, point.z()) / kFootprint;
}

TEST(CurveSmoothingTest, LineStays) {
  for (const Vector3d& point : Smooth(LinePoints(200), false)) {
    EXPECT_LT(LineErrorPx(point), 0.01);
  }
}

TEST(CurveSmoothingTest, ClosedCircleStays) {
  const double radius_px = 60;
  for (const Vector3d& point : Smooth(CirclePoints(377, radius_px), true)) {
    EXPECT_LT(CircleErrorPx(point, radius_px), 0.01);
  }
}

TEST(CurveSmoothingTest, NoiseOnALineIsReduced) {
  const std::vector<Vector3d> noisy = Noisy(LinePoints(400));
  const std::vector<Vector3d> smooth = Smooth(noisy, false);
  double before = 0, after = 0;
  for (size_t i = 0; i < noisy.size(); ++i) {
    before += std::pow(LineErrorPx(noisy[i]), 2);
    after += std::pow(LineErrorPx(smooth[i]), 2);
  }
  EXPECT_LT(std::sqrt(after), 0.5 * std::sqrt(before));
}

TEST(CurveSmoothingTest, NoiseOnACircleIsReduced) {
  const double radius_px = 60;
  const std::vector<Vector3d> noisy = Noisy(CirclePoints(377, radius_px));
  const std::vector<Vector3d> smooth = Smooth(noisy, true);
  double before = 0, after = 0;
  for (size_t i = 0; i < noisy.size(); ++i) {
    before += std::pow(CircleErrorPx(noisy[i], radius_px), 2);
    after += std::pow(CircleErrorPx(smooth[i], radius_px), 2);
  }
  EXPECT_LT(std::sqrt(after), 0.5 * std::sqrt(before));
}

TEST(CurveSmoothingTest, TwoPointsStay) {
  const std::vector<Vector3d> points = LinePoints(2);
  EXPECT_EQ(Smooth(points, false), points);
}

}  // namespace
}  // namespace limn
