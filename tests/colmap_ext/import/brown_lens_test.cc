// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/brown_lens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kLensPath = "a.csv";

Camera WithLens(const BrownLens& lens) {
  Camera camera;
  camera.width = 4000;
  camera.height = 3000;
  camera.params = {3000, 3010, 2010, 1490};
  SetBrownLens(lens, {kLensPath, "line", 7}, &camera);
  return camera;
}

TEST(BrownLens, TakesTheSimplestCameraThatHasIt) {
  EXPECT_EQ(WithLens({}).model, CameraModelId::kPinhole);
  const Camera opencv = WithLens({{0.1, 0, 0, 0}, 0, 0.01});
  EXPECT_EQ(opencv.model, CameraModelId::kOpencv);
  EXPECT_THAT(opencv.params, ElementsAre(3000, 3010, 2010, 1490, 0.1, 0, 0, 0.01));
  const Camera full = WithLens({{0.1, 0.2, 0.3, 0}, 0.01, 0.02});
  EXPECT_EQ(full.model, CameraModelId::kFullOpencv);
  EXPECT_THAT(full.params, ElementsAre(3000, 3010, 2010, 1490, 0.1, 0.2, 0.01, 0.02, 0.3, 0, 0, 0));
}

TEST(BrownLens, FourthTermIsFitted) {
  // As Metashape found it for a real camera.
  const BrownLens lens = {{-0.0919, -0.0763, 0.1163, -0.0761}, 0.0001, -0.0003};
  const Camera camera = WithLens(lens);
  ASSERT_EQ(camera.model, CameraModelId::kFullOpencv);
  const std::vector<double>& p = camera.params;
  EXPECT_EQ(p[6], lens.p1);
  EXPECT_EQ(p[7], lens.p2);
  for (double r = 0.05; r < 0.84; r += 0.05) {  // the corner is at 0.84
    const double u = r * r;
    const double expected = 1 + u * (lens.k[0] + u * (lens.k[1] + u * (lens.k[2] + u * lens.k[3])));
    const double fitted =
        (1 + u * (p[4] + u * (p[5] + u * p[8]))) / (1 + u * (p[9] + u * (p[10] + u * p[11])));
    EXPECT_NEAR(3010 * r * fitted, 3010 * r * expected, 0.01) << r;
  }
}

TEST(BrownLens, WhatCannotBeFittedIsRefused) {
  // It folds within the image.
  for (const double k4 : {-50.0, -1e300}) {
    const BrownLens lens = {{-0.5, 0, 0, k4}, 0, 0};
    EXPECT_THAT(ErrorText<IoError>([&] { WithLens(lens); }),
                HasSubstr("a.csv: line 7: the radial distortion with k4"))
        << k4;
  }
}

TEST(BrownLens, FisheyesHaveTangentialTermsToo) {
  Camera camera;
  camera.params = {800, 800, 320, 240};
  SetFisheyeLens({{1, 2, 3, 4}, 0, 0}, &camera);
  EXPECT_EQ(camera.model, CameraModelId::kOpencvFisheye);
  EXPECT_THAT(camera.params, ElementsAre(800, 800, 320, 240, 1, 2, 3, 4));
  camera.params.resize(4);
  SetFisheyeLens({{1, 2, 3, 4}, 5, 6}, &camera);
  EXPECT_EQ(camera.model, CameraModelId::kThinPrismFisheye);
  EXPECT_THAT(camera.params, ElementsAre(800, 800, 320, 240, 1, 2, 5, 6, 3, 4, 0, 0));
}

}  // namespace
}  // namespace limn::colmap_ext
