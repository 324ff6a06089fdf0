// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/edge_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/model/toy_lens.h"

namespace limn {
namespace {

EdgeMap OneEdgelAt(double x, double y, double tangent_rad) {
  EdgeMap map;
  map.width = map.height = 101;
  Edgel edgel;
  edgel.position_px = {x, y};
  edgel.tangent_rad = tangent_rad;
  edgel.strength = 3;
  map.edgels = {edgel};
  return map;
}

TEST(ApplyLens, WithoutALensOnlyFillsStoredPositions) {
  EdgeMap map = OneEdgelAt(10.5, 20.25, 0.3);
  const std::vector<bool> usable = ApplyLens(nullptr, &map);
  EXPECT_TRUE(usable[0]);
  EXPECT_EQ(map.edgels[0].stored_px, Eigen::Vector2f(10.5f, 20.25f));
  EXPECT_EQ(map.edgels[0].position_px, Eigen::Vector2d(10.5, 20.25));
  EXPECT_EQ(map.edgels[0].tangent_rad, 0.3);
  EXPECT_EQ(map.edgels[0].stored_from_virtual, Eigen::Matrix2f::Identity());
}

TEST(ApplyLens, MovesPositionTangentAndJacobian) {
  const ToyLens lens({50, 50}, 2, 0.25, 45);
  EdgeMap map = OneEdgelAt(60, 40, 0.3);
  ApplyLens(&lens, &map);
  const Edgel& edgel = map.edgels[0];
  EXPECT_LT((edgel.position_px - *lens.VirtualFromStored({60, 40})).norm(), 1e-12);
  EXPECT_EQ(edgel.stored_px, Eigen::Vector2f(60, 40));
  EXPECT_NEAR(edgel.tangent_rad, 0.3 - 0.25, 1e-9);
  EXPECT_LT((edgel.stored_from_virtual.cast<double>() - lens.Jacobian()).norm(), 1e-5);
  EXPECT_EQ(map.num_outside_lens, 0);
}

TEST(ApplyLens, EdgelsBeyondTheLensKeepTheirIdsAndAreCounted) {
  const ToyLens lens({50, 50}, 2, 0, 45);
  EdgeMap map = OneEdgelAt(60, 40, 0.3);
  map.edgels.push_back(map.edgels[0]);
  map.edgels[0].position_px = {99, 99};
  const std::vector<bool> usable = ApplyLens(&lens, &map);
  EXPECT_EQ(usable, (std::vector<bool>{false, true}));
  ASSERT_EQ(map.edgels.size(), 2u);
  EXPECT_EQ(map.edgels[0].strength, 0);
  EXPECT_EQ(map.edgels[1].strength, 3);
  EXPECT_EQ(map.num_outside_lens, 1);
}

TEST(Edgel, NormalPointsLeftOnScreenOfTheTangent) {
  Edgel edgel;
  edgel.tangent_rad = M_PI / 2;  // walking down the screen, left is +x
  EXPECT_LT((edgel.Tangent() - Eigen::Vector2d(0, 1)).norm(), 1e-12);
  EXPECT_LT((edgel.Normal() - Eigen::Vector2d(1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace limn
