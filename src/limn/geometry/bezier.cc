// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/bezier.h"

#include <algorithm>
#include <iterator>

namespace limn {
namespace {

constexpr int kDegree = 3;

// The blossom of a spline's polynomial between the knots `span` and `span` + 1.
Eigen::Vector3d Blossom(const CubicBSpline& spline, int span, const std::array<double, 3>& at) {
  CubicBezier3d point;
  std::copy_n(spline.control_points.begin() + (span - kDegree), kDegree + 1, point.begin());
  for (int level = 1; level <= kDegree; ++level) {
    for (int j = kDegree; j >= level; --j) {
      const int i = span - kDegree + j;
      const double first = spline.knots[i];
      const double last = spline.knots[i + kDegree + 1 - level];
      const double part = (at[level - 1] - first) / (last - first);
      point[j] = (1 - part) * point[j - 1] + part * point[j];
    }
  }
  return point[kDegree];
}

}  // namespace

std::vector<CubicBezier3d> BezierPieces(const CubicBSpline& spline, double t0, double t1) {
  const double first = spline.knots.front();
  const double range = spline.knots.back() - first;
  std::vector<CubicBezier3d> pieces;
  for (int span = kDegree; span + kDegree + 1 < std::ssize(spline.knots); ++span) {
    const double a = std::max(first + t0 * range, spline.knots[span]);
    const double b = std::min(first + t1 * range, spline.knots[span + 1]);
    if (!(a < b)) continue;
    pieces.push_back({Blossom(spline, span, {a, a, a}), Blossom(spline, span, {a, a, b}),
                      Blossom(spline, span, {a, b, b}), Blossom(spline, span, {b, b, b})});
  }
  return pieces;
}

}  // namespace limn
