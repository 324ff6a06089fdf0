// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/shape_part.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(ShapePart, IsTheSameCurve) {
  CubicBSpline spline;
  spline.knots = {0, 0, 0, 0, 1, 3, 4, 4, 4, 4};
  spline.control_points = {{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {3, 0, 2}, {4, 1, 0}, {5, 0, 0}};
  const CircularArc arc = {{1, 2, 3}, {0, 1, 0}, {0, 0, 1}, 2, 5};
  for (const CurveShape& shape :
       {CurveShape(spline), CurveShape(arc), CurveShape(LineSegment{{0, 0, 0}, {1, 2, 3}})}) {
    const CurveShape part = PartOf(shape, 0.2, 0.9);
    EXPECT_EQ(ValidateShape(part), "");
    EXPECT_LT((PointAt(part, 0) - PointAt(shape, 0.2)).norm(), 1e-12);
    EXPECT_LT((PointAt(part, 1) - PointAt(shape, 0.9)).norm(), 1e-12);
    const Polyline3d whole = SampleShape(shape, 1e-7);
    for (const double t : {0.1, 0.37, 0.6}) {
      EXPECT_LT(ClosestPoint(whole, PointAt(part, t)).squared_distance, 1e-12);
    }
  }
}

}  // namespace
}  // namespace limn
