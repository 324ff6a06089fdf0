// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/rigid3.h"

#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

Rigid3d RandomRigid(std::mt19937* random) {
  testing::NormalDistribution<double> normal;
  Rigid3d rigid;
  rigid.rotation =
      Eigen::Quaterniond(normal(*random), normal(*random), normal(*random), normal(*random))
          .normalized();
  rigid.translation = {normal(*random), normal(*random), normal(*random)};
  return rigid;
}

TEST(Rigid3d, InverseAndCompositionActOnPoints) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Rigid3d b_from_a = RandomRigid(&random);
    const Rigid3d c_from_b = RandomRigid(&random);
    const Eigen::Vector3d point_in_a = RandomRigid(&random).translation;
    EXPECT_LT((Inverse(b_from_a) * (b_from_a * point_in_a) - point_in_a).norm(), 1e-12);
    EXPECT_LT(((c_from_b * b_from_a) * point_in_a - c_from_b * (b_from_a * point_in_a)).norm(),
              1e-12);
  }
}

TEST(Rigid3d, RotatesThenTranslates) {
  Rigid3d rigid;
  rigid.rotation = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  rigid.translation = {10, 0, 0};
  EXPECT_LT((rigid * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(10, 1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace limn
