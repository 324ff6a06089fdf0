// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_calibration.h"

#include <cmath>

#include <gtest/gtest.h>

#include "colmap_ext/model/camera_lens_map.h"
#include "colmap_ext/model/test_model.h"

namespace limn::colmap_ext {
namespace {

class EveryCalibration : public ::testing::TestWithParam<int> {
 protected:
  // Images of half the size.
  const Optics optics_ =
      MakeOptics(MakeCamera(static_cast<CameraModelId>(GetParam()), 1), 400, 300);
};

Eigen::Vector2d StoredPx(const Optics& optics, const Eigen::Vector3d& ray) {
  const Eigen::Vector2d px = optics.camera.Project(ray);
  return optics.lens ? optics.lens->StoredFromVirtual(px).value() : px;
}

TEST_P(EveryCalibration, DerivativesAreThoseOfThePixel) {
  const Eigen::VectorXd parameters = optics_.calibration->Parameters();
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.3, 0.1}, {-0.2, 0.25}, {0.02, -0.3}}) {
    const Eigen::Vector3d ray(x, y, 1);
    const auto columns = optics_.calibration->StoredByParameters(optics_.camera.Project(ray));
    ASSERT_TRUE(columns);
    ASSERT_EQ(columns->cols(), parameters.size());
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
      const double step = 1e-5 * std::max(1.0, std::abs(parameters[i]));
      Eigen::VectorXd changed = parameters;
      changed[i] += step;
      const Eigen::Vector2d above = StoredPx(optics_.calibration->WithParameters(changed), ray);
      changed[i] -= 2 * step;
      const Eigen::Vector2d below = StoredPx(optics_.calibration->WithParameters(changed), ray);
      const Eigen::Vector2d expected = (above - below) / (2 * step);
      EXPECT_LT((columns->col(i) - expected).norm(), 1e-4 * (1 + expected.norm()))
          << "parameter " << i << " at " << x << " " << y << ": " << columns->col(i).transpose()
          << ", expected " << expected.transpose();
    }
  }
}

TEST_P(EveryCalibration, TheSameParametersGiveTheSameOptics) {
  const Optics same = optics_.calibration->WithParameters(optics_.calibration->Parameters());
  const Eigen::Vector3d ray(0.2, -0.1, 1);
  EXPECT_EQ(StoredPx(same, ray), StoredPx(optics_, ray));
  EXPECT_EQ(same.camera.width, 400);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryCalibration, ::testing::Range(0, 17));

}  // namespace
}  // namespace limn::colmap_ext
