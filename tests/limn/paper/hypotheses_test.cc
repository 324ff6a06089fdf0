// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/hypotheses.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

constexpr double kMinDepth = 2;
constexpr double kMaxDepth = 12;

class HypothesesTest : public ::testing::Test {
 protected:
  // Hypotheses of the first fragment of the first view with the second view.
  std::vector<CurveHypothesis> Find(const std::vector<testing::SceneCurve>& curves,
                                    double min_depth = kMinDepth, double max_depth = kMaxDepth) {
    first_ = testing::ProjectCurves(primary_, curves);
    second_curves_ = testing::ProjectCurves(second_, curves);
    const FragmentChords chords_of_second(second_curves_);
    const EpipolarChords chords(primary_, second_, chords_of_second);
    rays_ = MakeFragmentRays(primary_, first_, 0);
    return FindHypotheses(rays_, primary_, second_, chords, min_depth, max_depth);
  }

  const View primary_ = testing::LookAt({5, 0, 1}, {0, 0, 0});
  const View second_ = testing::LookAt({4.6, 1.9, 1.2}, {0, 0, 0});
  ImageCurves first_;
  ImageCurves second_curves_;
  FragmentRays rays_;
};

TEST_F(HypothesesTest, LineIsReconstructedExactly) {
  const Vector3d from(-0.2, -0.3, -0.7), to(0.3, 0.2, 0.8);
  const auto hypotheses = Find({testing::Segment(from, to)});
  ASSERT_EQ(hypotheses.size(), 1u);
  EXPECT_EQ(hypotheses[0].second_fragment, 0);
  // Every vertex but those at the ends, where the other view may end a fraction earlier.
  EXPECT_GE(hypotheses[0].samples.size() + 3, rays_.size());
  const Vector3d a = primary_.cam_from_world * from, b = primary_.cam_from_world * to;
  const Vector3d direction = (b - a).normalized();
  int last_vertex = -1;
  for (const HypothesisSample& sample : hypotheses[0].samples) {
    EXPECT_GT(sample.vertex, last_vertex);
    last_vertex = sample.vertex;
    // The point of the line on the vertex's ray: z of the intersection of ray and line.
    const Vector3d ray = rays_.rays[sample.vertex];
    const Vector3d normal = direction.cross(ray).cross(direction);
    const double depth = normal.dot(a) / normal.dot(ray);
    EXPECT_NEAR(sample.depth, depth, 1e-6 * depth) << "vertex " << sample.vertex;
    EXPECT_NEAR((sample.tangent_in_cam - direction).norm(), 0, 1e-5) << "vertex " << sample.vertex;
    EXPECT_GT(sample.epipolar_sine, 0.3);
    EXPECT_GT(sample.triangulation_sine, 0.2);
  }
}

TEST_F(HypothesesTest, TangentPointsAlongTheFragment) {
  const Vector3d from(0.3, 0.2, 0.8), to(-0.2, -0.3, -0.7);  // the other way round
  const auto hypotheses = Find({testing::Segment(from, to)});
  ASSERT_EQ(hypotheses.size(), 1u);
  const Vector3d direction = primary_.cam_from_world.rotation * (to - from).normalized();
  for (const HypothesisSample& sample : hypotheses[0].samples) {
    EXPECT_NEAR((sample.tangent_in_cam - direction).norm(), 0, 1e-5);
  }
}

TEST_F(HypothesesTest, CirclePointsLieOnTheCircle) {
  const Vector3d center(0.1, -0.1, 0.2);
  const auto hypotheses = Find({testing::Circle(center, 0.6)});
  ASSERT_FALSE(hypotheses.empty());
  const Rigid3d world_from_cam = Inverse(primary_.cam_from_world);
  int on_circle = 0;
  for (const CurveHypothesis& hypothesis : hypotheses) {
    for (const HypothesisSample& sample : hypothesis.samples) {
      const Vector3d point = world_from_cam * (sample.depth * rays_.rays[sample.vertex]) - center;
      on_circle += std::abs(point.z()) < 0.01 && std::abs(point.head<2>().norm() - 0.6) < 0.01;
    }
  }
  EXPECT_GT(on_circle, 0.7 * static_cast<double>(rays_.size()));
}

TEST_F(HypothesesTest, ParallelLineIsAHypothesisOfItsOwn) {
  const auto hypotheses = Find({testing::Segment({0, 0, -0.7}, {0, 0, 0.7}),
                                testing::Segment({-0.5, 0.4, -0.7}, {-0.5, 0.4, 0.7})});
  ASSERT_EQ(hypotheses.size(), 2u);
  EXPECT_NE(hypotheses[0].second_fragment, hypotheses[1].second_fragment);
}

TEST_F(HypothesesTest, NoneLeavesTheDepthRange) {
  const Vector3d from(1.0, -0.3, -0.7), to(-1.0, 0.2, 0.8);
  const double middle = (primary_.cam_from_world * Vector3d(0, 0, 0)).z();
  const auto all = Find({testing::Segment(from, to)});
  const auto half = Find({testing::Segment(from, to)}, kMinDepth, middle);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_LT(half[0].samples.size(), all[0].samples.size());
  for (const HypothesisSample& sample : half[0].samples) EXPECT_LE(sample.depth, middle + 1e-6);
  EXPECT_TRUE(Find({testing::Segment(from, to)}, 8, 12).empty());
}

}  // namespace
}  // namespace limn
