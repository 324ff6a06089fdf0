// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "limn/drawing/samples.h"
#include "limn/geometry/tangent_frame.h"
#include "support/random_numbers.h"

namespace limn::testing {

// A curve by arc length from its start, px.
struct PxCurve {
  std::function<Eigen::Vector3d(double)> at;
  double length_px = 0;

  Eigen::Vector3d Tangent(double arc_px) const {
    constexpr double kStep = 1e-4;
    return (at(arc_px + kStep) - at(arc_px - kStep)).normalized();
  }
};

inline PxCurve LineBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d direction = (to - from).normalized();
  return {[=](double arc_px) -> Eigen::Vector3d { return from + arc_px * direction; },
          (to - from).norm()};
}

// In the plane z = center.z; negative turns are clockwise.
inline PxCurve ArcAround(const Eigen::Vector3d& center, double radius_px, double from_rad,
                         double turn_rad) {
  const double per_px = std::copysign(1 / radius_px, turn_rad);
  return {[=](double arc_px) -> Eigen::Vector3d {
            const double angle = from_rad + arc_px * per_px;
            return center + radius_px * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
          },
          radius_px* std::abs(turn_rad)};
}

inline PxCurve CircleAround(const Eigen::Vector3d& center, double radius_px) {
  return ArcAround(center, radius_px, 0, 2 * M_PI);
}

// Standard deviations of samples in each direction across their curve, px: along z, and in the
// others. Those of the tangent are angles.
struct SampleNoise {
  double lateral_px = 0;
  double depth_px = 0;
  double tangent_rad = 0;

  static SampleNoise Even(double px) { return {px, px, 0}; }
};

// Samples of several primary views along known curves. Each has an edgel of its own as support.
class SampleMaker {
 public:
  explicit SampleMaker(double footprint = 1, double spacing_px = 1)
      : footprint_(footprint), spacing_px_(spacing_px) {}

  // A curve of the sketch. Samples of different views lie at different places.
  void Add(const PxCurve& curve, ViewId view, const SampleNoise& noise = {}) {
    CurveOrigin origin;
    origin.sketch_curve = samples_.NumCurves();
    origin.begin = 3;
    origin.primary_view = view;
    samples_.origins.push_back(origin);
    for (double arc = std::fmod(0.37 * view, 1); arc <= curve.length_px; arc += spacing_px_) {
      AddSample(curve.at(arc), curve.Tangent(arc), view, noise);
    }
    samples_.curve_begin.push_back(samples_.NumSamples());
  }
  void AddInViews(const PxCurve& curve, ViewId begin, ViewId end, const SampleNoise& noise = {}) {
    for (ViewId view = begin; view < end; ++view) Add(curve, view, noise);
  }

  const SampleSet& samples() const { return samples_; }

 private:
  void AddSample(const Eigen::Vector3d& place_px, const Eigen::Vector3d& tangent, ViewId view,
                 const SampleNoise& noise) {
    const Eigen::Vector3d sigmas(noise.lateral_px, noise.lateral_px, noise.depth_px);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
    const Eigen::Vector3d offset = across * sigmas.cwiseProduct(Normal());
    // Samples without noise are determined to a tenth of a px.
    const Eigen::Vector3d known_to_px = sigmas.cwiseMax(0.1);
    const Eigen::Matrix3d per_px =
        across * known_to_px.cwiseAbs2().cwiseInverse().asDiagonal() * across;
    samples_.position.push_back(footprint_ * (place_px + offset));
    samples_.tangent.push_back((tangent + noise.tangent_rad * across * Normal()).normalized());
    samples_.information.push_back(per_px / (footprint_ * footprint_));
    samples_.footprint.push_back(footprint_);
    samples_.curve_of.push_back(samples_.NumCurves() - 1);
    const EdgelRef edgel = {view, samples_.NumSamples()};
    samples_.support.Append({&edgel, 1});
  }

  Eigen::Vector3d Normal() {
    testing::NormalDistribution<double> normal;
    const double x = normal(random_);
    const double y = normal(random_);
    return {x, y, normal(random_)};
  }

  double footprint_;
  double spacing_px_;
  std::mt19937 random_{7};
  SampleSet samples_;
};

}  // namespace limn::testing
