// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/pull_cost.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr double kRobustPx = 0.5;
constexpr double kScale = 3;
// Parameter blocks: two ends.
constexpr int kSizes[] = {3, 3};

using Blocks = std::vector<std::vector<double>>;

View SomeView() {
  View view;
  view.camera = {600, 580, 310, 240, 640, 480};
  view.cam_from_world.rotation = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, -1).normalized());
  view.cam_from_world.translation = {0.1, -0.2, 3};
  return view;
}

Edgel SomeEdgel() {
  Edgel edgel;
  edgel.position_px = {330, 205};
  edgel.tangent_rad = 0.7;
  edgel.stored_from_virtual << 1.1F, 0.05F, -0.02F, 0.9F;
  return edgel;
}

// The second end at any height.
Blocks SomeBlocks(double z) { return {{0.2, 0.1, 0.3}, {0.5, -0.2, z}}; }

std::vector<const double*> PointersTo(const Blocks& blocks) {
  std::vector<const double*> pointers;
  for (const std::vector<double>& block : blocks) pointers.push_back(block.data());
  return pointers;
}

double Residual(const PullCost& cost, const Blocks& blocks) {
  double residual = 0;
  EXPECT_TRUE(cost.Evaluate(PointersTo(blocks).data(), &residual, nullptr));
  return residual;
}

// Distance from the edgel's tangent line by the definition.
double DistancePx(const View& view, const Edgel& edgel, const Blocks& blocks, double t) {
  const Eigen::Vector3d place =
      (1 - t) * Eigen::Vector3d(blocks[0].data()) + t * Eigen::Vector3d(blocks[1].data());
  const Eigen::Vector2d pixel = view.camera.Project(view.cam_from_world * place);
  const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
  const Eigen::Vector2d offset = stored_from_virtual * (pixel - edgel.position_px);
  const Eigen::Vector2d tangent = (stored_from_virtual * edgel.Tangent()).normalized();
  return offset.x() * tangent.y() - offset.y() * tangent.x();
}

TEST(PullCost, TheSquareIsCauchysLoss) {
  const View view = SomeView();
  const Edgel edgel = SomeEdgel();
  const PullCost cost({{&view, edgel, kScale}}, {0.7, 0.3}, kRobustPx);
  for (const double z : {-0.1, 0.1, 0.2}) {
    const Blocks blocks = SomeBlocks(z);
    const double relative = DistancePx(view, edgel, blocks, 0.3) / kRobustPx;
    const double residual = Residual(cost, blocks);
    const double expected = std::pow(kScale * kRobustPx, 2) * std::log1p(relative * relative);
    EXPECT_GT(std::abs(relative), 2);
    EXPECT_NEAR(residual * residual, expected, 1e-9 * expected);
    EXPECT_EQ(residual > 0, relative > 0);
  }
}

// Central differences: errors of 1e-6 squared times the third derivatives, and of rounding.
TEST(PullCost, DerivativesAreThoseOfTheResidual) {
  const View view = SomeView();
  for (const double robust_px : {kRobustPx, 50.0, std::numeric_limits<double>::infinity()}) {
    const PullCost cost({{&view, SomeEdgel(), kScale}}, {0.7, 0.3}, robust_px);
    for (const double z : {-0.5, 0.1, 0.4}) {
      Blocks blocks = SomeBlocks(z);
      Blocks jacobians;
      std::vector<double*> rows;
      for (const int size : kSizes) jacobians.emplace_back(size);
      for (std::vector<double>& of_block : jacobians) rows.push_back(of_block.data());
      double residual = 0;
      ASSERT_TRUE(cost.Evaluate(PointersTo(blocks).data(), &residual, rows.data()));
      for (size_t b = 0; b < blocks.size(); ++b) {
        for (size_t i = 0; i < blocks[b].size(); ++i) {
          const double value = blocks[b][i];
          blocks[b][i] = value + 1e-6;
          const double above = Residual(cost, blocks);
          blocks[b][i] = value - 1e-6;
          const double below = Residual(cost, blocks);
          blocks[b][i] = value;
          const double expected = (above - below) / 2e-6;
          EXPECT_NEAR(jacobians[b][i], expected, 1e-5 * (1 + std::abs(expected)))
              << "block " << b << " entry " << i << " z " << z << " robust " << robust_px;
        }
      }
    }
  }
}

TEST(PullCost, EveryPullHasItsOwnLoss) {
  const View view = SomeView();
  Edgel other = SomeEdgel();
  other.position_px.x() += 40;
  const PullCost both({{&view, SomeEdgel(), kScale}, {&view, other, 1}}, {0.7, 0.3}, kRobustPx);
  const PullCost second({{&view, other, 1}}, {0.7, 0.3}, kRobustPx);
  const Blocks blocks = SomeBlocks(0.1);
  double residuals[2] = {0, 0};
  ASSERT_TRUE(both.Evaluate(PointersTo(blocks).data(), residuals, nullptr));
  EXPECT_EQ(residuals[1], Residual(second, blocks));
}

TEST(PullCost, NothingIsGainedBehindTheCamera) {
  const View view = SomeView();
  const PullCost cost({{&view, SomeEdgel(), kScale}}, {0.7, 0.3}, kRobustPx);
  Blocks blocks = SomeBlocks(0.1);
  const double in_front = Residual(cost, blocks);
  blocks[0] = blocks[1] = {0, 0, -10};
  EXPECT_GT(std::abs(Residual(cost, blocks)), std::abs(in_front));
}

}  // namespace
}  // namespace limn
