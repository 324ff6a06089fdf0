// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_model.h"

#include <gtest/gtest.h>

#include "colmap_ext/model/test_model.h"

namespace limn::colmap_ext {
namespace {

TEST(CameraModel, IsFoundByIdAndByName) {
  for (int32_t id = 0; id <= 17; ++id) {
    const CameraModel* model = FindCameraModel(id);
    ASSERT_NE(model, nullptr);
    EXPECT_EQ(static_cast<int32_t>(model->id), id);
    EXPECT_EQ(FindCameraModel(std::string_view(model->name)), model);
  }
  EXPECT_EQ(FindCameraModel(-1), nullptr);
  EXPECT_EQ(FindCameraModel(18), nullptr);
  EXPECT_EQ(FindCameraModel("PINHOLES"), nullptr);
}

TEST(CameraModel, AllModelsAreSupported) {
  for (int32_t id = 0; id <= 17; ++id) {
    EXPECT_NE(SupportedCameraModels().find(FindCameraModel(id)->name), std::string::npos) << id;
  }
}

TEST(CameraModel, SingleFocalLengthIsDoubled) {
  const Intrinsics one = IntrinsicsOf(MakeCamera(CameraModelId::kRadial, 1));
  EXPECT_EQ(one.fx, 500.5);
  EXPECT_EQ(one.fy, 500.5);
  EXPECT_EQ(one.cx, 403.25);
  EXPECT_EQ(one.cy, 297.75);
  EXPECT_EQ(one.extra, (std::vector<double>{-0.1, 0.03}));
  EXPECT_EQ(IntrinsicsOf(MakeCamera(CameraModelId::kEucm, 1)).fy, 510.25);
}

TEST(CameraModel, RescalingLeavesExtraParametersAlone) {
  const Intrinsics half = Rescaled(IntrinsicsOf(MakeCamera(CameraModelId::kRadial, 1)), 0.5, 0.25);
  EXPECT_EQ(half.fx, 250.25);
  EXPECT_EQ(half.fy, 125.125);
  EXPECT_EQ(half.cx, 201.625);
  EXPECT_EQ(half.cy, 74.4375);
  EXPECT_EQ(half.extra, (std::vector<double>{-0.1, 0.03}));
}

TEST(CameraModel, ZeroDistortionIsPinholeButNeverForFisheyes) {
  const auto zeroed = [](CameraModelId id) {
    Intrinsics intrinsics = IntrinsicsOf(MakeCamera(id, 1));
    for (double& extra : intrinsics.extra) extra = 1e-9;
    return intrinsics;
  };
  using Id = CameraModelId;
  for (const Id id : {Id::kSimplePinhole, Id::kPinhole, Id::kSimpleRadial, Id::kRadial, Id::kOpencv,
                      Id::kFullOpencv, Id::kFov, Id::kSimpleDivision, Id::kDivision, Id::kEucm}) {
    EXPECT_TRUE(IsPinhole(zeroed(id))) << static_cast<int>(id);
  }
  for (const Id id :
       {Id::kSimpleFisheye, Id::kFisheye, Id::kOpencvFisheye, Id::kRadialFisheye,
        Id::kSimpleRadialFisheye, Id::kThinPrismFisheye, Id::kRadTanThinPrismFisheye}) {
    EXPECT_FALSE(IsPinhole(zeroed(id))) << static_cast<int>(id);
  }
  for (const Id id : {Id::kSimpleRadial, Id::kRadial, Id::kOpencv, Id::kFullOpencv, Id::kFov,
                      Id::kSimpleDivision, Id::kDivision, Id::kEucm}) {
    EXPECT_FALSE(IsPinhole(IntrinsicsOf(MakeCamera(id, 1)))) << static_cast<int>(id);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
