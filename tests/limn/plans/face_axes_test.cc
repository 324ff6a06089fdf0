// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/face_axes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/face_drawing.h"

namespace limn {
namespace {

void ExpectRightHanded(const Eigen::Matrix3d& axes) {
  EXPECT_LT((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
}

TEST(FaceAxes, AreUprightWhereUpIsKnown) {
  for (const DrawingFace& face : testing::UnitCube().faces) {
    const Eigen::Matrix3d axes = AxesAlong(face, Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
    ExpectRightHanded(axes);
    EXPECT_LT((axes.row(2).transpose() + face.normal).norm(), 1e-12);
    if (std::abs(face.normal.z()) > 0.5) continue;
    EXPECT_LT((axes.row(1).transpose() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
  // Seen from the front (along y), x is to the right.
  const DrawingFace front = testing::UnitCube().faces[2];
  ASSERT_LT((front.normal + Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT(
      (AxesAlong(front, Eigen::Vector3d(0, 0, 1)).row(0).transpose() - Eigen::Vector3d::UnitX())
          .norm(),
      1e-12);
}

TEST(FaceAxes, ElseTheLongestDirectionIsLevel) {
  testing::FaceDrawing drawing;
  const std::vector<LinkId> links = {
      drawing.AddLine({0, 0, 0}, {0, 5, 1}), drawing.AddLine({0, 5, 1}, {0, 4, 2}),
      drawing.AddLine({0, 4, 2}, {0, 0, 1}), drawing.AddLine({0, 0, 1}, {0, 0, 0})};
  drawing.AddPlane({drawing.Loop(links)});
  const DrawingFace face = drawing.graph().faces[0];
  const Eigen::Vector3d longest = Eigen::Vector3d(0, 5, 1).normalized();
  for (const auto& up : {std::optional<Eigen::Vector3d>(), std::optional(face.normal)}) {
    const Eigen::Matrix3d axes = AxesAlong(face, up);
    ExpectRightHanded(axes);
    EXPECT_NEAR(std::abs(axes.row(0).dot(longest)), 1, 1e-12);
  }
}

}  // namespace
}  // namespace limn
