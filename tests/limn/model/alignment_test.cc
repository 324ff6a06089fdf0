// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/alignment.h"

#include <limits>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Alignment, IsValidIfItIsASimilarity) {
  Alignment alignment;
  EXPECT_EQ(Validate(alignment), "");
  alignment.world_from_model.scale = 0;
  EXPECT_EQ(Validate(alignment), "the scale is not positive");
  alignment.world_from_model.scale = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Validate(alignment), "a number is not finite");
  alignment = {};
  alignment.world_from_model.rotation(0, 1) = 0.1;
  EXPECT_EQ(Validate(alignment), "the matrix is not a rotation");
  alignment.world_from_model.rotation = -Eigen::Matrix3d::Identity();
  EXPECT_EQ(Validate(alignment), "the matrix is not a rotation");
}

TEST(Alignment, FollowsADrawingThatIsMoved) {
  Alignment alignment;
  alignment.world_from_model.scale = 3;
  alignment.world_from_model.translation = {1, 2, 3};
  alignment.scale = ScaleSource::kLengths;
  const Similarity3d file_from_model = {
      0.5, Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY()).toRotationMatrix(), {7, 8, 9}};
  const Alignment moved = After(file_from_model, alignment);
  const Eigen::Vector3d point(4, 5, 6);
  EXPECT_LT(
      (moved.world_from_model * (file_from_model * point) - alignment.world_from_model * point)
          .norm(),
      1e-12);
  EXPECT_EQ(moved.scale, ScaleSource::kLengths);
}

}  // namespace
}  // namespace limn
