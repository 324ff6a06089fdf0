// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/draw_options.h"

#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

TEST(DrawerOptions, TheTruthCountsInTheBox) {
  DrawerOptions options;
  options.run.box = {0, 1, -2, 2, 3, 4};
  options.run.pipeline.edges.margin_px = 3;
  options.SetDerived();
  ASSERT_TRUE(options.truth.evaluation.region);
  EXPECT_EQ(options.truth.evaluation.region->min(), Eigen::Vector3d(0, -2, 3));
  EXPECT_EQ(options.run.view.border_margin_px, 3);
}

}  // namespace
}  // namespace limn::colmap_ext
