// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's library, 3.9 or later, as an oracle for lenses: every camera model that it has, 100
// cameras of random parameters each, 100 random points in the image of each.
//
// COLMAP's undistortion stops at a step of 1e-5 and follows numerical derivatives. It is therefore
// compared twice: as it is, and continued to a root by Newton steps on COLMAP's projection with
// COLMAP's derivatives (ceres::Jet).
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

#include <Eigen/LU>
#include <ceres/jet.h>
#include <colmap/sensor/models.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/camera_lens_map.h"
#include "colmap_ext/model/test_model.h"
#include "limn/model/lens_jacobian.h"
#include "support/random_numbers.h"

namespace limn::colmap_ext {
namespace {

constexpr int kNumCameras = 100;
constexpr int kPointsPerCamera = 100;
// Of the longer side of the image.
constexpr double kTolerance = 1e-9;
// Of the derivative. Ours comes from differences over a pixel.
constexpr double kJacobianTolerance = 1e-5;

using Jet = ceres::Jet<double, 2>;

template <typename T>
void ColmapPixel(int model, const T* params, T u, T v, T* x, T* y) {
  switch (static_cast<colmap::CameraModelId>(model)) {
#define CAMERA_MODEL_CASE(CameraModel)                         \
  case colmap::CameraModel::model_id:                          \
    colmap::CameraModel::ImgFromCam(params, u, v, T(1), x, y); \
    break;
    CAMERA_MODEL_CASES
#undef CAMERA_MODEL_CASE
    default:
      FAIL() << model;
  }
}

// Of one of COLMAP's versions.
[[maybe_unused]] Eigen::Vector2d RayOf(const Eigen::Vector3d& ray) { return ray.hnormalized(); }
[[maybe_unused]] Eigen::Vector2d RayOf(const std::optional<Eigen::Vector2d>& ray) {
  return ray.value_or(Eigen::Vector2d::Constant(std::nan("")));
}

// COLMAP's side of a camera.
class ColmapLens {
 public:
  explicit ColmapLens(const Camera& camera) : camera_(camera) {
    for (const double param : camera.params) jets_.emplace_back(param);
  }

  Eigen::Vector2d Pixel(const Eigen::Vector2d& ray, Eigen::Matrix2d* jacobian) const {
    Jet x, y;
    ColmapPixel(static_cast<int>(camera_.model), jets_.data(), Jet(ray.x(), 0), Jet(ray.y(), 1), &x,
                &y);
    jacobian->row(0) = x.v.transpose();
    jacobian->row(1) = y.v.transpose();
    return {x.a, y.a};
  }

  // As COLMAP undistorts.
  Eigen::Vector2d GivenRay(const Eigen::Vector2d& pixel) const {
    return RayOf(colmap::CameraModelCamFromImg(static_cast<colmap::CameraModelId>(camera_.model),
                                               camera_.params, pixel));
  }

  // Continued to the root; nothing if there is none nearby.
  std::optional<Eigen::Vector2d> Ray(const Eigen::Vector2d& pixel) const {
    Eigen::Vector2d ray = GivenRay(pixel);
    for (int i = 0; i < 3; ++i) {
      Eigen::Matrix2d jacobian;
      const Eigen::Vector2d residual = Pixel(ray, &jacobian) - pixel;
      if (!(residual.norm() < 1)) return std::nullopt;
      ray -= jacobian.inverse() * residual;
    }
    return ray;
  }

 private:
  const Camera& camera_;
  std::vector<Jet> jets_;
};

struct Worst {
  double projection = 0, undistortion = 0, given_undistortion = 0, derivative = 0, jacobian = 0;
  int outside = 0;  // of what we map
  int failed = 0;   // COLMAP's undistortion comes near no root
};

void Raise(double value, double* worst) {
  if (!(value <= *worst)) *worst = std::isnan(value) ? HUGE_VAL : value;
}

class ColmapLibrary : public ::testing::TestWithParam<int> {
 protected:
  bool IsFisheye() const {
    return std::string(FindCameraModel(GetParam())->name).find("FISHEYE") != std::string::npos;
  }

  double Random(double low, double high) {
    return testing::UniformDistribution<double>(low, high)(random_);
  }

  // In the range of real lenses: distortion up to 1.2 times that of MakeCamera, of either sign but
  // for models whose parameter has only one (COLMAP's FOV is not the model's below 0.01).
  Camera RandomCamera() {
    Camera camera = MakeCamera(static_cast<CameraModelId>(GetParam()), 1);
    camera.width = std::lround(Random(640, 6000));
    camera.height = std::lround(Random(0.5, 1.2) * static_cast<double>(camera.width));
    const double size = static_cast<double>(std::max(camera.width, camera.height));
    const int num_focals = FindCameraModel(GetParam())->num_focals;
    camera.params[0] = size * (IsFisheye() ? Random(0.6, 1) : Random(0.7, 2));
    if (num_focals == 2) camera.params[1] = camera.params[0] * Random(0.95, 1.05);
    camera.params[num_focals] = static_cast<double>(camera.width) * Random(0.45, 0.55);
    camera.params[num_focals + 1] = static_cast<double>(camera.height) * Random(0.45, 0.55);
    const bool has_sign =
        camera.model != CameraModelId::kFov && camera.model != CameraModelId::kEucm;
    for (size_t i = num_focals + 2; i < camera.params.size(); ++i) {
      camera.params[i] *= has_sign ? Random(-1.2, 1.2) : Random(0.4, 1.2);
    }
    return camera;
  }

  std::mt19937 random_{1};
};

// How far our Jacobian is from COLMAP's, px per px: against the same differences of COLMAP's
// projection, and against its exact derivative.
void CompareJacobians(const ColmapLens& colmap, const CameraLensMap& lens, const Intrinsics& k,
                      const Eigen::Vector2d& pixel, double size, Worst* worst) {
  const Eigen::Vector2d half(0.5, 0.5);
  const auto through_lens = ThroughLens(&lens, pixel - half);
  const auto ray = colmap.Ray(pixel);
  if (!through_lens || !ray) return;
  const Eigen::Matrix2d& jacobian = through_lens->stored_from_virtual;
  const Eigen::Vector2d per_focal(1 / k.fx, 1 / k.fy);
  Eigen::Matrix2d unused;
  Eigen::Matrix2d differences;
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d step = per_focal.cwiseProduct(0.5 * Eigen::Vector2d::Unit(axis));
    differences.col(axis) = colmap.Pixel(*ray + step, &unused) - colmap.Pixel(*ray - step, &unused);
  }
  Raise((jacobian - differences).cwiseAbs().maxCoeff() / size, &worst->derivative);
  Eigen::Matrix2d exact;
  colmap.Pixel(*ray, &exact);
  exact = exact * per_focal.asDiagonal();
  Raise((jacobian - exact).norm() / exact.norm(), &worst->jacobian);
}

void Compare(const Camera& camera, const Eigen::Vector2d& pixel, const CameraLensMap& lens,
             const CameraProjection& projection, Worst* worst) {
  const Intrinsics& k = projection.intrinsics();
  const double size = static_cast<double>(std::max(camera.width, camera.height));
  const ColmapLens colmap(camera);
  const auto ray = projection.RayFromPixel(pixel);
  if (!ray) {
    ++worst->outside;
    return;
  }
  Eigen::Matrix2d jacobian;
  const Eigen::Vector2d theirs = colmap.Pixel(*ray, &jacobian);
  Raise((theirs - pixel).norm() / size, &worst->projection);
  Raise((theirs - projection.PixelFromRay(*ray).value()).norm() / size, &worst->projection);

  const auto distance = [&](const Eigen::Vector2d& other) {
    return Eigen::Vector2d(k.fx * (other.x() - ray->x()), k.fy * (other.y() - ray->y())).norm() /
           size;
  };
  const auto root = colmap.Ray(pixel);
  if (!root) {
    ++worst->failed;
    return;
  }
  Raise(distance(colmap.GivenRay(pixel)), &worst->given_undistortion);
  Raise(distance(*root), &worst->undistortion);
  CompareJacobians(colmap, lens, k, pixel, size, worst);
}

TEST_P(ColmapLibrary, HasTheSameLenses) {
  if (!colmap::ExistsCameraModelWithId(static_cast<colmap::CameraModelId>(GetParam()))) {
    GTEST_SKIP() << "this version of COLMAP has no " << FindCameraModel(GetParam())->name;
  }
  Worst worst;
  for (int c = 0; c < kNumCameras; ++c) {
    const Camera camera = RandomCamera();
    const CameraProjection projection(IntrinsicsOf(camera));
    const CameraLensMap lens(IntrinsicsOf(camera));
    for (int i = 0; i < kPointsPerCamera; ++i) {
      const Eigen::Vector2d pixel(Random(0, static_cast<double>(camera.width)),
                                  Random(0, static_cast<double>(camera.height)));
      Compare(camera, pixel, lens, projection, &worst);
    }
  }
  std::printf(
      "%s, of the image size: projection %.1e, undistortion %.1e (as COLMAP leaves it %.1e, "
      "failed %d), derivative %.1e per px (of the exact one %.1e); outside %d\n",
      FindCameraModel(GetParam())->name, worst.projection, worst.undistortion,
      worst.given_undistortion, worst.failed, worst.derivative, worst.jacobian, worst.outside);
  EXPECT_LE(worst.projection, kTolerance);
  EXPECT_LE(worst.undistortion, kTolerance);
  EXPECT_LE(worst.given_undistortion, kTolerance);
  EXPECT_LE(worst.derivative, kTolerance);
  EXPECT_LE(worst.jacobian, kJacobianTolerance);
  EXPECT_EQ(worst.outside, 0);
  EXPECT_EQ(worst.failed, 0);
}

INSTANTIATE_TEST_SUITE_P(Every, ColmapLibrary, ::testing::Range(0, 17), [](const auto& model) {
  return std::string(FindCameraModel(model.param)->name);
});

}  // namespace
}  // namespace limn::colmap_ext
