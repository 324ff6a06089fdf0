// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_projection.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/angles.h"

namespace limn::colmap_ext {
namespace {

CameraProjection Projection(CameraModelId model, std::vector<double> extra) {
  return CameraProjection({model, 1, 1, 0, 0, std::move(extra)});
}

class EveryModel : public ::testing::TestWithParam<int> {
 protected:
  CameraModelId Model() const { return static_cast<CameraModelId>(GetParam()); }
};

TEST_P(EveryModel, RoundTripsOverTheWholeImage) {
  const Camera camera = MakeCamera(Model(), 1);
  const CameraProjection projection(IntrinsicsOf(camera));
  double worst = 0;
  for (double y = 0; y <= 600; y += 12.5) {
    for (double x = 0; x <= 800; x += 12.5) {
      const auto ray = projection.RayFromPixel({x, y});
      ASSERT_TRUE(ray) << x << " " << y;
      const auto pixel = projection.PixelFromRay(*ray);
      ASSERT_TRUE(pixel) << x << " " << y;
      worst = std::max(worst, (*pixel - Eigen::Vector2d(x, y)).norm());
    }
  }
  EXPECT_LT(worst, 1e-8);
}

TEST_P(EveryModel, RaysComeBackFromTheirPixels) {
  const CameraProjection projection(IntrinsicsOf(MakeCamera(Model(), 1)));
  const double radius = 0.98 * projection.MaxRadius();
  ASSERT_GT(radius, 0.5);
  for (int i = 0; i < 360; i += 15) {
    for (const double share : {0.0, 1e-7, 0.01, 0.3, 0.7, 1.0}) {
      const Eigen::Vector2d ray =
          share * radius * Eigen::Vector2d(std::cos(i * kDeg), std::sin(i * kDeg));
      const auto pixel = projection.PixelFromRay(ray);
      ASSERT_TRUE(pixel);
      const auto back = projection.RayFromPixel(*pixel);
      ASSERT_TRUE(back) << ray.transpose();
      EXPECT_LT((*back - ray).norm(), 1e-9) << ray.transpose();
    }
  }
}

TEST_P(EveryModel, NothingBeyondTheDomain) {
  const CameraProjection projection(IntrinsicsOf(MakeCamera(Model(), 1)));
  EXPECT_LE(projection.MaxRadius(), std::tan(75 * kDeg) + 1e-12);
  EXPECT_FALSE(projection.PixelFromRay({projection.MaxRadius() + 1e-6, 0}));
  EXPECT_FALSE(projection.PixelFromRay({std::nan(""), 0}));
  EXPECT_FALSE(projection.RayFromPixel({1e7, 300}));
  EXPECT_FALSE(projection.RayFromPixel({std::nan(""), 300}));
}

INSTANTIATE_TEST_SUITE_P(CameraProjection, EveryModel, ::testing::Range(0, 17),
                         [](const auto& model) {
                           return std::string(FindCameraModel(model.param)->name);
                         });

// Values worked out by hand at (u, v) = (0.3, -0.4): r^2 = 0.25.
TEST(CameraProjection, FollowsTheFormulaOfRadialModels) {
  const auto pixel = Projection(CameraModelId::kRadial, {0.2, 0.4}).PixelFromRay({0.3, -0.4});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 0.3 * 1.075, 1e-15);
  EXPECT_NEAR(pixel->y(), -0.4 * 1.075, 1e-15);
}

TEST(CameraProjection, FollowsTheFormulaOfTangentialDistortion) {
  const auto pixel =
      Projection(CameraModelId::kOpencv, {0, 0, 0.01, 0.02}).PixelFromRay({0.3, -0.4});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 0.3 + 2 * 0.01 * -0.12 + 0.02 * (0.25 + 2 * 0.09), 1e-15);
  EXPECT_NEAR(pixel->y(), -0.4 + 2 * 0.02 * -0.12 + 0.01 * (0.25 + 2 * 0.16), 1e-15);
}

TEST(CameraProjection, ProjectAriaSwapsTheTangentialParameters) {
  std::vector<double> extra(12, 0.0);
  extra[6] = 0.01;   // p0: with the terms of x
  extra[10] = 0.03;  // s2: r^2 in y
  const Eigen::Vector2d ray(0.3, -0.4);
  const Eigen::Vector2d p = ray * (std::atan(0.5) / 0.5);
  const auto pixel = Projection(CameraModelId::kRadTanThinPrismFisheye, extra).PixelFromRay(ray);
  ASSERT_TRUE(pixel);
  const double r2 = p.squaredNorm();
  EXPECT_NEAR(pixel->x(), p.x() + 0.01 * (r2 + 2 * p.x() * p.x()), 1e-15);
  EXPECT_NEAR(pixel->y(), p.y() + 2 * 0.01 * p.x() * p.y() + 0.03 * r2, 1e-15);
}

TEST(CameraProjection, EquidistantFisheyeMeasuresAngles) {
  const auto pixel = Projection(CameraModelId::kSimpleFisheye, {}).PixelFromRay({0, std::tan(1.0)});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->y(), 1.0, 1e-15);
}

TEST(CameraProjection, DivisionHasItsClosedInverse) {
  const double k = -0.3;
  const Eigen::Vector2d distorted(0.5, -0.2);
  const auto ray = Projection(CameraModelId::kSimpleDivision, {k}).RayFromPixel(distorted);
  ASSERT_TRUE(ray);
  EXPECT_LT((*ray - distorted / (1 + k * distorted.squaredNorm())).norm(), 1e-11);
}

TEST(CameraProjection, DivisionWithoutARootHasNoPixel) {
  EXPECT_FALSE(Projection(CameraModelId::kSimpleDivision, {0.5}).PixelFromRay({1, 0}));
}

TEST(CameraProjection, EucmHasItsClosedInverse) {
  const double alpha = 0.7;
  const double beta = 1.2;
  const Eigen::Vector2d distorted(0.4, 0.3);
  const double r2 = distorted.squaredNorm();
  const double m = (1 - alpha * alpha * beta * r2) /
                   (alpha * std::sqrt(1 - (2 * alpha - 1) * beta * r2) + 1 - alpha);
  const auto ray = Projection(CameraModelId::kEucm, {alpha, beta}).RayFromPixel(distorted);
  ASSERT_TRUE(ray);
  EXPECT_LT((*ray - distorted / m).norm(), 1e-11);
}

TEST(CameraProjection, FovWithoutAngleIsTheIdentityInTheLimit) {
  const Eigen::Vector2d ray(0.7, -0.2);
  for (const double omega : {0.0, 1e-6, 0.99e-4, 1.01e-4}) {
    const auto pixel = Projection(CameraModelId::kFov, {omega}).PixelFromRay(ray);
    ASSERT_TRUE(pixel);
    // Next term of the series: omega^2 (1/12 - r^2/3).
    const double scale = 1 + omega * omega * (1.0 / 12 - ray.squaredNorm() / 3);
    EXPECT_LT((*pixel - ray * scale).norm(), 1e-15);
  }
}

TEST(CameraProjection, StopsWhereThePolynomialFoldsOver) {
  // r (1 - 0.3 r^2) is largest at r = sqrt(1 / 0.9).
  const CameraProjection projection = Projection(CameraModelId::kSimpleRadial, {-0.3});
  const double fold = std::sqrt(1 / 0.9);
  EXPECT_LE(projection.MaxRadius(), fold);
  EXPECT_GT(projection.MaxRadius(), fold - 0.02);
  EXPECT_FALSE(projection.PixelFromRay({1.2, 0}));
  EXPECT_FALSE(projection.RayFromPixel({fold * (1 - 0.3 * fold * fold) + 1e-3, 0}));
}

TEST(CameraProjection, FisheyesStopAt75Degrees) {
  const CameraProjection projection = Projection(CameraModelId::kSimpleFisheye, {});
  EXPECT_TRUE(projection.RayFromPixel({0, 74.9 * kDeg}));
  for (const double angle : {75.1, 89.9, 90.0, 120.0, 180.0}) {
    EXPECT_FALSE(projection.RayFromPixel({0, angle * kDeg})) << angle;
  }
}

TEST(CameraProjection, DegenerateModelMapsNothing) {
  EXPECT_EQ(Projection(CameraModelId::kSimpleRadial, {std::nan("")}).MaxRadius(), 0);
  EXPECT_FALSE(Projection(CameraModelId::kSimpleRadial, {std::nan("")}).RayFromPixel({0.1, 0}));
  // sqrt(1 - r^2) has no value beyond r = 1.
  EXPECT_LE(Projection(CameraModelId::kEucm, {1, -1}).MaxRadius(), 1);
}

// COLMAP's undistorter moves the 2D points of each image to an undistorted PINHOLE camera: an
// oracle for unprojection.
TEST(CameraProjection, AgreesWithColmapImageUndistorter) {
  if (!HaveColmap()) GTEST_SKIP() << "colmap is not installed";
  const TempDir dir;
  std::filesystem::create_directories(dir / "images");
  std::filesystem::create_directories(dir / "sparse");
  SparseModel model;
  for (int id = 2; id <= 10; ++id) {
    Camera camera = MakeCamera(static_cast<CameraModelId>(id), id);
    ModelImage image;
    image.id = image.camera_id = id;
    image.name = std::to_string(id) + ".png";
    for (double y = 50; y < 600; y += 100) {
      for (double x = 50; x < 800; x += 100) image.observations.push_back({{x, y}, kNoPoint3D});
    }
    cv::imwrite((dir / "images" / image.name).string(), cv::Mat(600, 800, CV_8UC3, cv::Scalar(9)));
    model.cameras.push_back(camera);
    model.images.push_back(image);
  }
  WriteModelBinary(model, dir / "sparse");
  ASSERT_TRUE(RunColmap("image_undistorter --input_path '" + (dir / "sparse").string() +
                            "' --image_path '" + (dir / "images").string() + "' --output_path '" +
                            (dir / "dense").string() + "'",
                        dir / "log"));
  const SparseModel undistorted = ReadColmapModel(dir / "dense" / "sparse");
  ASSERT_EQ(undistorted.images.size(), model.images.size());
  for (const ModelImage& image : undistorted.images) {
    const Camera& camera = model.cameras[image.id - 2];
    const CameraProjection projection(IntrinsicsOf(camera));
    const Intrinsics pinhole = IntrinsicsOf(undistorted.CameraOf(image));
    ASSERT_EQ(pinhole.model, CameraModelId::kPinhole);
    const auto& before = model.images[image.id - 2].observations;
    ASSERT_EQ(image.observations.size(), before.size());
    for (size_t i = 0; i < before.size(); ++i) {
      const auto ray = projection.RayFromPixel(before[i].position);
      ASSERT_TRUE(ray);
      const Eigen::Vector2d pixel(pinhole.fx * ray->x() + pinhole.cx,
                                  pinhole.fy * ray->y() + pinhole.cy);
      EXPECT_LT((pixel - image.observations[i].position).norm(), 1e-6)
          << FindCameraModel(static_cast<int32_t>(camera.model))->name << " at "
          << before[i].position.transpose();
    }
  }
}

}  // namespace
}  // namespace limn::colmap_ext
