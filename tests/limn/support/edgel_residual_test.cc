// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/edgel_residual.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

class EdgelResidualTest : public ::testing::Test {
 protected:
  EdgelResidualTest() {
    view_.camera.fy = 620;  // not square
    edgel_ = testing::MakeEdgel({300, 250}, 0.7);
  }

  View view_ = testing::LookAt({3, 2, 4}, {0, 0, 0});
  Edgel edgel_;
};

TEST_F(EdgelResidualTest, IsTheDistanceFromTheTangentLine) {
  const Vector3d point(0.1, -0.2, 0.3);
  const Eigen::Vector2d pixel = view_.Project(point).value();
  const auto residual = ResidualToEdgel(view_, edgel_, point);
  ASSERT_TRUE(residual.has_value());
  EXPECT_NEAR(residual->residual_px, edgel_.Normal().dot(pixel - edgel_.position_px), 1e-9);
}

TEST_F(EdgelResidualTest, GradientAgreesWithFiniteDifferences) {
  std::mt19937 random(2);
  testing::UniformDistribution<double> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    edgel_.tangent_rad = M_PI * uniform(random);
    edgel_.stored_from_virtual << 0.9f, 0.1f * static_cast<float>(uniform(random)), -0.05f, 1.1f;
    const Vector3d point = testing::RandomVector(uniform, random);
    const auto residual = ResidualToEdgel(view_, edgel_, point);
    ASSERT_TRUE(residual.has_value());
    const double step = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d shift = step * Vector3d::Unit(axis);
      const double difference = ResidualToEdgel(view_, edgel_, point + shift)->residual_px -
                                ResidualToEdgel(view_, edgel_, point - shift)->residual_px;
      EXPECT_NEAR(residual->gradient[axis], difference / (2 * step), 1e-4);
    }
  }
}

TEST_F(EdgelResidualTest, BehindTheCameraIsNothing) {
  const Vector3d behind(6, 4, 8);
  EXPECT_FALSE(ResidualToEdgel(view_, edgel_, behind).has_value());
  EXPECT_FALSE(ProjectedDirection(view_, behind, Vector3d::UnitX()).has_value());
}

TEST_F(EdgelResidualTest, NumbersThatOverflowHaveNoDirection) {
  const double huge = std::numeric_limits<double>::max();
  EXPECT_FALSE(ProjectedDirection(view_, Vector3d::Zero(), huge * Vector3d(1, 1, 1)));
  EXPECT_FALSE(See(view_, Vector3d::Zero(), huge * Vector3d(1, 1, 1)));
}

TEST_F(EdgelResidualTest, ProjectedDirectionIsThatOfASmallStep) {
  const Vector3d point(0.1, -0.2, 0.3);
  const Vector3d tangent = Vector3d(1, 2, -0.5).normalized();
  const Eigen::Vector2d step =
      view_.Project(point + 1e-6 * tangent).value() - view_.Project(point).value();
  const auto direction = ProjectedDirection(view_, point, tangent);
  ASSERT_TRUE(direction.has_value());
  EXPECT_LT((*direction - step.normalized()).norm(), 1e-5);
}

}  // namespace
}  // namespace limn
