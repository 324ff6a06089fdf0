// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/point_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

constexpr double kVariance = 0.04;

// Views around a line along the x axis, with an edgel each where it shows the origin.
class PointFitTest : public ::testing::Test {
 protected:
  PointFitTest() {
    for (const double angle : {-0.6, 0.0, 0.6, 1.2}) {
      views_.push_back(testing::LookAt({0.5, 4 * std::sin(angle), 4 * std::cos(angle)}, {0, 0, 0}));
    }
    for (const View& view : views_) {
      const auto sight = See(view, Vector3d::Zero(), Vector3d::UnitX()).value();
      edgels_.push_back(testing::MakeEdgel(sight.position_px,
                                           std::atan2(sight.direction.y(), sight.direction.x())));
    }
  }

  std::vector<EdgelTarget> Targets() const {
    std::vector<EdgelTarget> targets;
    for (size_t v = 0; v < views_.size(); ++v)
      targets.push_back({views_[v], edgels_[v], kVariance});
    return targets;
  }

  PointFit Fit(const Vector3d& start, double prior_sigma, double robust_px, int num_steps) const {
    PointFit fit(start, Vector3d::UnitX(), prior_sigma, robust_px);
    for (int i = 0; i < num_steps; ++i) fit.StepTo(Targets());
    return fit;
  }

  std::vector<View> views_;
  std::vector<Edgel> edgels_;
};

TEST_F(PointFitTest, PointMovesAcrossToTheLine) {
  const PointFit fit = Fit({0.3, 0.01, -0.02}, 1e3, 1e3, 3);
  EXPECT_LT((fit.position() - Vector3d(0.3, 0, 0)).norm(), 1e-6);
}

TEST_F(PointFitTest, PriorHoldsThePoint) {
  const Vector3d start(0, 0.01, -0.02);
  EXPECT_LT((Fit(start, 1e-9, 1e3, 3).position() - start).norm(), 1e-9);
  PointFit alone(start, Vector3d::UnitX(), 1, 1);
  alone.StepTo({});
  EXPECT_EQ(alone.position(), start);
  EXPECT_TRUE(alone.Information().isZero(0));
}

TEST_F(PointFitTest, FarEdgelsCountLinearly) {
  edgels_[3].position_px += 30 * edgels_[3].Normal().cast<double>();
  const Vector3d robust = Fit({0, 0, 0}, 1e3, 0.5, 20).position();
  const Vector3d squares = Fit({0, 0, 0}, 1e3, 1e3, 20).position();
  EXPECT_LT(10 * robust.norm(), squares.norm());
}

TEST_F(PointFitTest, InformationIsThatOfTheDistances) {
  const PointFit fit = Fit({0, 0, 0}, 1, 1, 1);
  const Vector3d offset(0, 1e-4, 2e-4);
  double squares = 0;
  for (size_t v = 0; v < views_.size(); ++v) {
    squares += std::pow(ResidualToEdgel(views_[v], edgels_[v], offset)->residual_px, 2) / kVariance;
  }
  EXPECT_NEAR(offset.dot(fit.Information() * offset) / squares, 1, 1e-3);
  EXPECT_LT((fit.Information() * Vector3d::UnitX()).norm(), 1e-9);
}

}  // namespace
}  // namespace limn
