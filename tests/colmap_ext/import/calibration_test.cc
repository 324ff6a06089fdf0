// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

TEST(Calibration, SkewIsDroppedOnlyIfNegligible) {
  const std::string path = "k.txt";
  const FilePlace place{path, "line", 3};
  Eigen::Matrix3d k;
  k << 600, 0.1, 320, 0, 500, 240, 0, 0, 1;
  EXPECT_EQ(CameraFromCalibration(2 * k, {640, 480}, place).params,
            (std::vector<double>{600, 500, 320, 240}));
  k(0, 1) = -0.11;
  EXPECT_THAT(ErrorText<IoError>([&] {
                CameraFromCalibration(k, {640, 480}, place);
              }),
              HasSubstr("k.txt: line 3: the pixels are skewed: 0.0528 px"));
}

TEST(Calibration, ARotationWithFewDigitsIsMadeOne) {
  const std::string path = "r.txt";
  const FilePlace place{path, "line", 1};
  const Eigen::Matrix3d exact =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d rounded = (exact * 1e4).array().round() / 1e4;
  const Eigen::Matrix3d rotation = RotationFromMatrix(rounded, place).toRotationMatrix();
  EXPECT_LT((rotation - exact).norm(), 3e-4);
  EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace limn::colmap_ext
