// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/true_frame.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "limn/cameras/gauge.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Twelve views of the origin, and a model of them in a folder.
class TrueFrameOfModel : public ::testing::Test {
 protected:
  TrueFrameOfModel() {
    for (size_t v = 0; v < views_.size(); ++v) views_[v].name = std::to_string(v) + ".png";
  }

  void Store(const std::vector<View>& views) {
    SparseModel model;
    model.cameras = {{1, CameraModelId::kPinhole, 640, 480, {600, 600, 320, 240}}};
    for (const View& view : views) {
      ModelImage image;
      image.id = static_cast<uint32_t>(model.images.size() + 1);
      image.camera_id = 1;
      image.name = view.name;
      image.cam_from_world = view.cam_from_world;
      model.images.push_back(image);
    }
    WriteModelText(model, dir_.path());
  }

  TrueFrame Found(const std::vector<View>& views) const {
    return FindTrueFrame(views, dir_.path().string(), Eigen::Vector3d::Zero());
  }

  TempDir dir_;
  std::vector<View> views_ = limn::testing::DomeViews(12, 5);
};

TEST_F(TrueFrameOfModel, IsFoundByNamesFromAnyOther) {
  const Eigen::Affine3d model_from_true = Eigen::Translation3d(3, -1, 7) *
                                          Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 2) / 3) *
                                          Eigen::UniformScaling<double>(0.25);
  // Two images have no true camera, and the model has another order.
  Store({views_.rbegin(), views_.rend() - 2});
  const TrueFrame frame = Found(Moved(views_, model_from_true));
  EXPECT_TRUE(frame.true_from_model.isApprox(model_from_true.inverse(), 1e-9));
  ASSERT_EQ(frame.views.size(), 10u);
  EXPECT_EQ(frame.cameras.num_views, 10u);
  for (size_t v = 0; v < frame.views.size(); ++v) {
    EXPECT_EQ(frame.views[v].name, views_[v + 2].name);
    EXPECT_LT((frame.views[v].CenterInWorld() - views_[v + 2].CenterInWorld()).norm(), 1e-9);
  }
  EXPECT_LT(frame.cameras.center, 1e-9);
  EXPECT_LT(frame.cameras.rotation_deg, 1e-5);
  EXPECT_LT(frame.cameras.focal, 1e-12);
}

TEST_F(TrueFrameOfModel, WrongCamerasDoNotMoveIt) {
  Store(views_);
  std::vector<View> made = views_;
  std::swap(made[1].cam_from_world, made[7].cam_from_world);
  const TrueFrame frame = Found(made);
  EXPECT_TRUE(frame.true_from_model.isApprox(Eigen::Affine3d::Identity(), 1e-9));
  EXPECT_EQ(frame.cameras.num_wrong, 2u);
}

TEST_F(TrueFrameOfModel, CamerasAreMeasuredInIt) {
  Store(views_);
  std::vector<View> made = views_;
  double sign = 1;
  for (View& view : made) {
    Rigid3d roll;
    roll.rotation = Eigen::AngleAxisd(sign * 0.1 * kDeg, Eigen::Vector3d::UnitZ());
    view.cam_from_world = roll * view.cam_from_world;
    view.camera.fx *= 1.02;
    sign = -sign;
  }
  const CameraAccuracy cameras = Found(made).cameras;
  EXPECT_NEAR(cameras.focal, 0.01, 1e-9);
  EXPECT_NEAR(cameras.rotation_deg, 0.1, 0.02);
  EXPECT_NEAR(cameras.rotation_px, 600 * kDeg * cameras.rotation_deg, 1e-9);
}

// Cameras that a wrong principal point turned do not turn the world. What a turn leaves of the
// principal point's error across the image grows with the square of the field of view.
TEST_F(TrueFrameOfModel, RaysKnowThePrincipalPoint) {
  Store(views_);
  std::vector<View> made = views_;
  for (View& view : made) {
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(-std::atan(6.0 / 600), Eigen::Vector3d::UnitY());
    view.cam_from_world = turn * view.cam_from_world;
    view.camera.cx += 6;
  }
  const TrueFrame frame = Found(made);
  EXPECT_LT((frame.true_from_model.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-3);
  EXPECT_NEAR(frame.cameras.rotation_px, 6, 0.1);
  EXPECT_LT(frame.cameras.ray_px, 0.5);
  EXPECT_LT(frame.cameras.center, 2e-3);
}

TEST_F(TrueFrameOfModel, TooFewCommonImagesAreNamed) {
  Store({views_.begin(), views_.begin() + 2});
  EXPECT_THAT(ErrorText<IoError>([&] { Found(views_); }),
              AllOf(StartsWith(dir_.path().string()), HasSubstr("only 2 of the drawing's 12"),
                    HasSubstr("0.png"), HasSubstr("name the model with the true cameras")));
}

TEST_F(TrueFrameOfModel, AFolderWithoutModelIsNamed) {
  EXPECT_THAT(ErrorText<IoError>([&] { Found(views_); }),
              AllOf(StartsWith(dir_.path().string()), HasSubstr("cameras.bin")));
}

}  // namespace
}  // namespace limn::colmap_ext
