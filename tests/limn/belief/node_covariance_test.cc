// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/node_covariance.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "limn/model/footprint.h"
#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::LookAt;

constexpr double kSigma = 0.002;

// Views all around, so that directions across a curve are known alike.
class NodeCovarianceTest : public ::testing::Test {
 protected:
  NodeCovarianceTest() {
    for (const Eigen::Vector3d& center :
         {Eigen::Vector3d(5, 0.1, 0), Eigen::Vector3d(0.1, 5, 0), Eigen::Vector3d(0, 0.1, 5)}) {
      views_.push_back(LookAt(center, {0, 0, 0}));
    }
    footprint_ = PixelFootprint(views_, {0, 0, 0});
  }

  void AddLink(const Eigen::Vector3d& to, double sigma = kSigma) {
    DrawLink({{0, 0, 0}, to / 2, to}, {0, 1, 2}, &graph_);
    graph_.links.back().sigma.assign(3, sigma);
  }

  // Standard deviations along the axes of the node at the origin.
  Eigen::Vector3d Measure() {
    MeasureNodes(views_, {}, &graph_);
    for (const DrawingNode& node : graph_.nodes) {
      if (node.position_in_world.isZero(0)) return node.covariance.diagonal().cwiseSqrt();
    }
    return Eigen::Vector3d::Constant(-1);
  }

  std::vector<View> views_;
  double footprint_ = 0;
  DrawingGraph graph_;
};

TEST_F(NodeCovarianceTest, AnEndIsKnownAcrossItsLink) {
  AddLink({1, 0, 0});
  const Eigen::Vector3d sigmas = Measure();
  EXPECT_NEAR(sigmas.y(), kSigma, 0.1 * kSigma);
  EXPECT_NEAR(sigmas.z(), kSigma, 0.1 * kSigma);
  EXPECT_GT(sigmas.x(), footprint_);
  EXPECT_LT(sigmas.x(), 5 * footprint_);
}

TEST_F(NodeCovarianceTest, ACornerIsKnownInAllDirections) {
  AddLink({1, 0, 0});
  AddLink({0, 1, 0});
  const Eigen::Vector3d sigmas = Measure();
  EXPECT_NEAR(sigmas.x(), kSigma, 0.1 * kSigma);
  EXPECT_NEAR(sigmas.y(), kSigma, 0.1 * kSigma);
  EXPECT_NEAR(sigmas.z(), kSigma / std::sqrt(2), 0.1 * kSigma);
}

TEST_F(NodeCovarianceTest, IsUnknownWithoutSigmas) {
  AddLink({1, 0, 0}, std::numeric_limits<double>::infinity());
  EXPECT_EQ(Measure(), Eigen::Vector3d::Zero());
  AddLink({0, 1, 0}, kSigma);
  EXPECT_GT(Measure().minCoeff(), 0);
}

TEST_F(NodeCovarianceTest, OneCurveThatGoesOnTellsOnce) {
  AddLink({1, 0, 0});
  const Eigen::Vector3d alone = Measure();
  AddLink({-1, 0, 0});
  for (DrawingNode& node : graph_.nodes) {
    if (node.Degree() == 2) node.continuations = {{node.incident[0], node.incident[1]}};
  }
  EXPECT_NEAR((Measure() - alone).norm(), 0, 1e-9);
}

TEST_F(NodeCovarianceTest, DoubtedLinksTellNothingBesideFirmOnes) {
  AddLink({1, 0, 0});
  const Eigen::Vector3d alone = Measure();
  AddLink({0, 1, 0});
  graph_.links.back().tentative = true;
  EXPECT_NEAR((Measure() - alone).norm(), 0, 1e-12);
}

// Two views from nearby places, which measure depth (z) badly.
TEST_F(NodeCovarianceTest, TheDepthIsKnownAsItsViewsSay) {
  views_ = {LookAt({0.3, 0, -5}, {0, 0, 0}), LookAt({-0.3, 0, -5}, {0, 0, 0})};
  footprint_ = PixelFootprint(views_, {0, 0, 0});
  DrawLink({{0, 0, 0}, {0, 0.5, 0}, {0, 1, 0}}, {0, 1}, &graph_);
  graph_.links.back().sigma.assign(3, kSigma);
  const Eigen::Vector3d sigmas = Measure();
  EXPECT_GT(sigmas.z(), 5 * sigmas.x());
}

}  // namespace
}  // namespace limn
