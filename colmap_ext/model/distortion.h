// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "colmap_ext/model/camera_model.h"

// The distortion functions of COLMAP's camera models: (u, v) of a ray (u, v, 1) to the (u', v')
// that focal length and principal point turn into a pixel. Templates on the scalar, so that the
// Jacobian comes from automatic differentiation. Formulas: table in COLMAP's documentation of
// camera models.

namespace limn::colmap_ext::distortion {

template <typename T>
struct Point {
  T u;
  T v;
};

// atan(x) / x as a function of x^2, smooth at 0.
template <typename T>
T AtanRatio(const T& x2) {
  using std::atan2;
  using std::sqrt;
  if (x2 < 1e-6) return 1.0 + x2 * (-1.0 / 3 + x2 * (1.0 / 5 - x2 / 7.0));
  const T x = sqrt(x2);
  // The one has as many derivatives as x.
  return atan2(x, T(0.0 * x + 1.0)) / x;
}

// The equidistant mapping of the fisheye models: scales (u, v) to length theta = atan(r).
template <typename T>
Point<T> Equidistant(const Point<T>& p) {
  const T ratio = AtanRatio<T>(p.u * p.u + p.v * p.v);
  return {p.u * ratio, p.v * ratio};
}

// Scale by 1 + k[0] r^2 + k[1] r^4 + ...
template <typename T, typename E>
Point<T> Radial(const Point<T>& p, const E* k, int count) {
  const T r2 = p.u * p.u + p.v * p.v;
  T sum = r2 * k[count - 1];
  for (int i = count - 2; i >= 0; --i) sum = r2 * (k[i] + sum);
  return {p.u * (1.0 + sum), p.v * (1.0 + sum)};
}

// The tangential distortion at p; p1 multiplies 2uv in u.
template <typename T, typename E>
Point<T> Tangential(const Point<T>& p, const E& p1, const E& p2) {
  const T uv = p.u * p.v;
  const T r2 = p.u * p.u + p.v * p.v;
  return {2.0 * p1 * uv + p2 * (r2 + 2.0 * p.u * p.u), 2.0 * p2 * uv + p1 * (r2 + 2.0 * p.v * p.v)};
}

template <typename T>
Point<T> Sum(const Point<T>& a, const Point<T>& b) {
  return {a.u + b.u, a.v + b.v};
}

template <typename T, typename E>
Point<T> Opencv(const Point<T>& p, const E* e) {
  return Sum<T>(Radial(p, e, 2), Tangential(p, e[2], e[3]));
}

template <typename T, typename E>
Point<T> FullOpencv(const Point<T>& p, const E* e) {
  const T r2 = p.u * p.u + p.v * p.v;
  const T numerator = 1.0 + r2 * (e[0] + r2 * (e[1] + r2 * e[4]));
  const T denominator = 1.0 + r2 * (e[5] + r2 * (e[6] + r2 * e[7]));
  const T scale = numerator / denominator;
  return Sum<T>({p.u * scale, p.v * scale}, Tangential(p, e[2], e[3]));
}

template <typename T, typename E>
Point<T> Fov(const Point<T>& p, const E& omega) {
  // 2 tan(omega / 2), and its ratio to omega, which is 1 + omega^2 / 12 + ... near 0.
  using std::abs;
  using std::tan;
  const E t = 2.0 * tan(omega / 2.0);
  const E slope = abs(omega) < 1e-4 ? E(1.0 + omega * omega / 12.0) : E(t / omega);
  const T scale = slope * AtanRatio<T>((p.u * p.u + p.v * p.v) * (t * t));
  return {p.u * scale, p.v * scale};
}

// `p` has gone through Equidistant.
template <typename T, typename E>
Point<T> ThinPrism(const Point<T>& p, const E* e) {
  const E k[4] = {e[0], e[1], e[4], e[5]};
  const T r2 = p.u * p.u + p.v * p.v;
  const Point<T> prism = {e[6] * r2, e[7] * r2};
  return Sum<T>(Sum<T>(Radial(p, k, 4), Tangential(p, e[2], e[3])), prism);
}

// Project Aria's model; `p` has gone through Equidistant. Tangential and prism terms are taken at
// the radially distorted point, and p0 goes with the terms of u.
template <typename T, typename E>
Point<T> RadTanThinPrism(const Point<T>& p, const E* e) {
  const Point<T> radial = Radial(p, e, 6);
  const T r2 = radial.u * radial.u + radial.v * radial.v;
  const Point<T> prism = {r2 * (e[8] + r2 * e[9]), r2 * (e[10] + r2 * e[11])};
  return Sum<T>(Sum<T>(radial, Tangential(radial, e[7], e[6])), prism);
}

template <typename T, typename E>
Point<T> Division(const Point<T>& p, const E& k) {
  using std::sqrt;
  const T scale = 2.0 / (1.0 + sqrt(1.0 - 4.0 * k * (p.u * p.u + p.v * p.v)));
  return {p.u * scale, p.v * scale};
}

template <typename T, typename E>
Point<T> Eucm(const Point<T>& p, const E& alpha, const E& beta) {
  using std::sqrt;
  const T d = sqrt(beta * (p.u * p.u + p.v * p.v) + 1.0);
  const T denominator = alpha * d + (1.0 - alpha);
  return {p.u / denominator, p.v / denominator};
}

// Not finite where a model has no value (negative root).
// `e` are the extra parameters.
template <typename T, typename E>
Point<T> Distort(CameraModelId model, const E* e, const Point<T>& p) {
  switch (model) {
    case CameraModelId::kSimpleRadial:
      return Radial(p, e, 1);
    case CameraModelId::kRadial:
      return Radial(p, e, 2);
    case CameraModelId::kOpencv:
      return Opencv(p, e);
    case CameraModelId::kOpencvFisheye:
      return Radial(Equidistant(p), e, 4);
    case CameraModelId::kFullOpencv:
      return FullOpencv(p, e);
    case CameraModelId::kFov:
      return Fov(p, e[0]);
    case CameraModelId::kSimpleRadialFisheye:
      return Radial(Equidistant(p), e, 1);
    case CameraModelId::kRadialFisheye:
      return Radial(Equidistant(p), e, 2);
    case CameraModelId::kThinPrismFisheye:
      return ThinPrism(Equidistant(p), e);
    case CameraModelId::kRadTanThinPrismFisheye:
      return RadTanThinPrism(Equidistant(p), e);
    case CameraModelId::kSimpleDivision:
    case CameraModelId::kDivision:
      return Division(p, e[0]);
    case CameraModelId::kSimpleFisheye:
    case CameraModelId::kFisheye:
      return Equidistant(p);
    case CameraModelId::kEucm:
      return Eucm(p, e[0], e[1]);
    case CameraModelId::kSimplePinhole:
    case CameraModelId::kPinhole:
    case CameraModelId::kEquirectangular:  // has no such coordinates: see PanoramaParts
      break;
  }
  return p;
}

template <typename T>
Point<T> Distort(const Intrinsics& intrinsics, const Point<T>& p) {
  return Distort<T, double>(intrinsics.model, intrinsics.extra.data(), p);
}

}  // namespace limn::colmap_ext::distortion
