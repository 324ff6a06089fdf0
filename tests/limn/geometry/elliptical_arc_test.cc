// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/elliptical_arc.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

Eigen::Vector3d PointOn(const EllipticalArc& arc, double rad) {
  return arc.center + std::cos(rad) * arc.major + std::sin(rad) * arc.minor;
}

CircularArc RandomArc(std::mt19937* random) {
  testing::UniformDistribution<double> uniform(-1, 1);
  const auto vector = [&] { return testing::RandomVector(uniform, *random); };
  CircularArc arc;
  arc.center = vector();
  arc.x_axis = vector().normalized();
  arc.y_axis = arc.x_axis.cross(vector()).normalized();
  arc.radius = 1.5 + uniform(*random);
  arc.sweep_rad = std::numbers::pi * (1 + 0.99 * uniform(*random));
  return arc;
}

// Also seen from behind.
TEST(EllipticalArc, IsTheImageOfTheArc) {
  std::mt19937 random(1);
  Eigen::Matrix3d to_plane = Eigen::Vector3d(1, 1, 0).asDiagonal();
  const Eigen::Vector3d offset(3, -2, 0);
  for (int i = 0; i < 200; ++i) {
    const CircularArc arc = RandomArc(&random);
    const EllipticalArc image = ImageOf(arc, to_plane, offset);
    EXPECT_GE(image.major.norm(), image.minor.norm());
    EXPECT_NEAR(image.major.dot(image.minor), 0, 1e-9);
    EXPECT_GE(image.major.cross(image.minor).z(), -1e-12);
    EXPECT_GE(image.begin_rad, 0);
    EXPECT_LT(image.begin_rad, 2 * std::numbers::pi);
    EXPECT_NEAR(image.end_rad - image.begin_rad, arc.sweep_rad, 1e-9);
    const Eigen::Vector3d start = to_plane * PointAt(arc, 0) + offset;
    const Eigen::Vector3d end = to_plane * PointAt(arc, 1) + offset;
    const Eigen::Vector3d middle = to_plane * PointAt(arc, 0.5) + offset;
    const Eigen::Vector3d first = PointOn(image, image.begin_rad);
    const bool is_reversed = (first - start).norm() > 1e-6;
    EXPECT_LT((first - (is_reversed ? end : start)).norm(), 1e-9);
    EXPECT_LT((PointOn(image, image.end_rad) - (is_reversed ? start : end)).norm(), 1e-9);
    EXPECT_LT((PointOn(image, 0.5 * (image.begin_rad + image.end_rad)) - middle).norm(), 1e-9);
  }
}

TEST(EllipticalArc, ACircleIsAWholeEllipse) {
  CircularArc circle;
  circle.x_axis = {0.6, 0.8, 0};
  circle.y_axis = {0, 0, 1};
  circle.sweep_rad = 2 * std::numbers::pi;
  const EllipticalArc image = ImageOf(circle, Eigen::Matrix3d::Identity(), {0, 0, 0});
  EXPECT_EQ(image.begin_rad, 0);
  EXPECT_EQ(image.end_rad, 2 * std::numbers::pi);
}

}  // namespace
}  // namespace limn
