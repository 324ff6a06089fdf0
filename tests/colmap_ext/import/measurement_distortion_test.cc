// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/measurement_distortion.h"

#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

// Lenses as they are found, up to the corners of a wide-angle image (focal length 1000 px, diagonal
// 1800 px).
TEST(MeasurementDistortion, IsInverted) {
  for (const double r : {0.25, 0.1, 1e-9, -0.05}) {
    const auto inverted = InvertMeasurementDistortion(r, 0.9);
    ASSERT_TRUE(inverted.has_value());
    EXPECT_LT(1000 * inverted->max_error, 1e-3) << r;
    const std::vector<double>& k = inverted->extra;
    for (double m = 0.05; m < 0.9; m += 0.05) {
      const double p = m * (1 + r * m * m);
      const double u = p * p;
      const double factor =
          (1 + u * (k[0] + u * (k[1] + u * k[4]))) / (1 + u * (k[5] + u * (k[6] + u * k[7])));
      EXPECT_NEAR(1000 * p * factor, 1000 * m, 1e-3) << r;
    }
  }
  EXPECT_FALSE(InvertMeasurementDistortion(-1, 0.6).has_value());
}

}  // namespace
}  // namespace limn::colmap_ext
