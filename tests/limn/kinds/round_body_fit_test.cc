// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/round_body_fit.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kSeenFrom = 5;
constexpr double kPxPerUnit = 600 / kSeenFrom;
constexpr double kRadius = 0.2;
constexpr double kTopRadius = 0.1;

// An upright body around the z axis from z = -0.5 to 0.5, or a ball.
struct TestBody {
  RoundShape shape = RoundShape::kCylinder;
  double top_radius = kRadius;

  double RadiusAt(double z) const {
    if (shape == RoundShape::kSphere) return std::sqrt(kRadius * kRadius - z * z);
    return kRadius + (z + 0.5) * (top_radius - kRadius);
  }
  double SlopeAt(double z) const {
    return shape == RoundShape::kSphere ? -z / RadiusAt(z) : top_radius - kRadius;
  }
};

constexpr TestBody kCylinder;
constexpr TestBody kCone = {RoundShape::kCone, kTopRadius};
constexpr TestBody kBall = {RoundShape::kSphere};

// Where the outline on one side is at height z: the normal of the surface is across the ray.
Eigen::Vector3d OutlinePlace(const TestBody& body, const Eigen::Vector3d& view, double z,
                             int side) {
  const double radius = body.RadiusAt(z);
  // With the normal (cos t, sin t, -slope): normal . (place - view) = 0.
  const double flat = view.head<2>().norm();
  const double cosine = (radius - body.SlopeAt(z) * (z - view.z())) / flat;
  const double angle = std::atan2(view.y(), view.x()) + side * std::acos(cosine);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<OutlineSight> SightsOfShape(const TestBody& body, double noise_px,
                                        double spread_deg = 20) {
  std::vector<OutlineSight> sights;
  std::mt19937 random(7);
  testing::NormalDistribution<double> noise(0, noise_px);
  for (int v = 0; v < 8; ++v) {
    const View view = testing::RingView(spread_deg * v, kSeenFrom, 0.4 * v - 1);
    for (int k = -10; k <= 10; ++k) {
      const double z = (body.shape == RoundShape::kSphere ? 0.015 : 0.05) * k;
      for (const int side : {1, -1}) {
        OutlineSight& sight = sights.emplace_back();
        sight.view = v;
        sight.center = view.CenterInWorld();
        const Eigen::Vector3d place = OutlinePlace(body, sight.center, z, side);
        const Eigen::Vector3d axis(0, 0, body.shape == RoundShape::kSphere ? 0 : z);
        const Eigen::Vector3d outward = (place - axis).normalized();
        sight.ray = (place + noise(random) / kPxPerUnit * outward - sight.center).normalized();
        sight.px_per_unit = kPxPerUnit;
        sight.axis_point = axis + Eigen::Vector3d(0.01, -0.01, 0);
        sight.radius = 0.15;
      }
    }
  }
  return sights;
}

TEST(FitRoundBodyTest, ACylinderIsFound) {
  const auto body = FitRoundBody(SightsOfShape(kCylinder, 0));
  ASSERT_TRUE(body);
  EXPECT_EQ(body->shape, RoundShape::kCylinder);
  EXPECT_EQ(Validate(*body), "");
  EXPECT_NEAR(body->start_radius, kRadius, 1e-6);
  for (const Eigen::Vector3d& place : {body->start, body->end}) {
    EXPECT_LT(place.head<2>().norm(), 1e-6);
    EXPECT_NEAR(std::abs(place.z()), 0.5, 0.01);
  }
  EXPECT_LT(body->rms_px, 1e-3);
}

TEST(FitRoundBodyTest, AConeIsFound) {
  const auto body = FitRoundBody(SightsOfShape(kCone, 0));
  ASSERT_TRUE(body);
  EXPECT_EQ(body->shape, RoundShape::kCone);
  EXPECT_EQ(Validate(*body), "");
  const bool is_upward = body->start.z() < body->end.z();
  const double below = is_upward ? body->start_radius : body->end_radius;
  const double above = is_upward ? body->end_radius : body->start_radius;
  EXPECT_NEAR(below, kRadius, 1e-5);
  EXPECT_NEAR(above, kTopRadius, 1e-5);
  EXPECT_LT(body->rms_px, 1e-3);
}

TEST(FitRoundBodyTest, AConeEndsAtItsApex) {
  std::vector<OutlineSight> sights = SightsOfShape({RoundShape::kCone, 0}, 0);
  // What single outlines tell of the axis goes beyond the apex.
  for (OutlineSight& sight : sights) sight.axis_point.z() *= 1.2;
  const auto body = FitRoundBody(sights);
  ASSERT_TRUE(body);
  EXPECT_EQ(body->shape, RoundShape::kCone);
  EXPECT_EQ(Validate(*body), "");
  EXPECT_EQ(std::min(body->start_radius, body->end_radius), 0);
  const Eigen::Vector3d& apex = body->start_radius == 0 ? body->start : body->end;
  EXPECT_LT((apex - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-4);
}

TEST(FitRoundBodyTest, ABallIsFound) {
  const auto body = FitRoundBody(SightsOfShape(kBall, 0));
  ASSERT_TRUE(body);
  EXPECT_EQ(body->shape, RoundShape::kSphere);
  EXPECT_EQ(Validate(*body), "");
  EXPECT_LT(body->start.norm(), 1e-6);
  EXPECT_NEAR(body->start_radius, kRadius, 1e-6);
}

// Noise must not make a cylinder a cone, and the radius is known about as well as it is said to be.
TEST(FitRoundBodyTest, NoiseIsNoShape) {
  const auto body = FitRoundBody(SightsOfShape(kCylinder, 0.4));
  ASSERT_TRUE(body);
  EXPECT_EQ(body->shape, RoundShape::kCylinder);
  EXPECT_NEAR(body->rms_px, 0.4, 0.1);
  EXPECT_GT(body->radius_sigma, 0);
  EXPECT_LT(std::abs(body->start_radius - kRadius), 3 * body->radius_sigma);
}

TEST(FitRoundBodyTest, WhatIsNoRoundBodyHasNone) {
  std::vector<OutlineSight> sights = SightsOfShape(kCylinder, 0);
  for (size_t s = 0; s < sights.size(); s += 3) {
    sights[s].ray = (sights[s].ray + Eigen::Vector3d(0, 0, 0.02)).normalized();
    sights[s].ray +=
        (s % 2 == 0 ? 8 : -8) / 600.0 * sights[s].ray.cross(Eigen::Vector3d::UnitZ()).normalized();
    sights[s].ray.normalize();
  }
  EXPECT_FALSE(FitRoundBody(sights));
}

TEST(FitRoundBodyTest, ThreeViewsAreTooFew) {
  std::vector<OutlineSight> sights = SightsOfShape(kCylinder, 0);
  std::erase_if(sights, [](const OutlineSight& sight) { return sight.view > 2; });
  EXPECT_FALSE(FitRoundBody(sights));
}

// One side alone, from views close together: any radius fits.
TEST(FitRoundBodyTest, ARadiusThatIsNotMeasuredIsNotTold) {
  std::vector<OutlineSight> sights = SightsOfShape(kCylinder, 0.4, 0.5);
  std::vector<OutlineSight> one_side;
  for (size_t s = 0; s < sights.size(); s += 2) one_side.push_back(sights[s]);
  EXPECT_FALSE(FitRoundBody(one_side));
}

}  // namespace
}  // namespace limn
