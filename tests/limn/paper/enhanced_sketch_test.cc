// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/enhanced_sketch.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Only with the averaging of the paper does a rival with little support keep a hypothesis from
// being counted.
TEST(EnhancedSketchTest, TheRatioIsAskedForByThePaperOnly) {
  const auto views = testing::DomeViews(10, 5);
  const auto curves = testing::ProjectCurves(views, testing::CubeEdges(0.8));
  SketchOptions options;
  const auto num_samples = [&](DepthAveraging averaging, double ratio) {
    options.averaging = averaging;
    options.first_to_second_ratio = ratio;
    size_t count = 0;
    const SketchInput input = {{views, curves}};
    for (const Curve3D& curve : BuildEnhancedSketch(input, options, {}, nullptr).sketch.curves) {
      count += curve.size();
    }
    return count;
  };
  const size_t num_robust = num_samples(DepthAveraging::kRobust, 1);
  EXPECT_GT(num_robust, 0u);
  EXPECT_EQ(num_samples(DepthAveraging::kRobust, 1e6), num_robust);
  const size_t num_of_paper = num_samples(DepthAveraging::kPaper, 1);
  EXPECT_GT(num_of_paper, 0u);
  EXPECT_LT(num_samples(DepthAveraging::kPaper, 1e6), 0.9 * static_cast<double>(num_of_paper));
}

}  // namespace
}  // namespace limn
