// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "limn/drawing/samples.h"

namespace limn::testing {

// Unit tangents by central differences of the positions.
inline void RecomputeTangents(const SampleSet& samples, int curve,
                              std::vector<Eigen::Vector3d>* tangents) {
  const int begin = samples.curve_begin[curve];
  const int size = samples.Size(curve);
  const bool closed = samples.origins[curve].closed;
  for (int k = 0; k < size; ++k) {
    const int before = closed ? (k + size - 1) % size : std::max(k - 1, 0);
    const int after = closed ? (k + 1) % size : std::min(k + 1, size - 1);
    const Eigen::Vector3d chord =
        samples.position[begin + after] - samples.position[begin + before];
    if (chord.norm() > 0) (*tangents)[begin + k] = chord.normalized();
  }
}

// A sample set of these curves with footprint 1, information 100 across the curve and no support.
inline SampleSet MakeSamples(const std::vector<std::vector<Eigen::Vector3d>>& curves) {
  SampleSet samples;
  for (size_t c = 0; c < curves.size(); ++c) {
    CurveOrigin origin;
    origin.sketch_curve = static_cast<int>(c);
    origin.primary_view = static_cast<ViewId>(c);
    samples.origins.push_back(origin);
    for (const Eigen::Vector3d& point : curves[c]) {
      samples.position.push_back(point);
      samples.curve_of.push_back(static_cast<int>(c));
      samples.footprint.push_back(1);
      samples.support.Append({});
    }
    samples.curve_begin.push_back(samples.NumSamples());
  }
  samples.tangent.resize(samples.position.size());
  for (int c = 0; c < samples.NumCurves(); ++c) RecomputeTangents(samples, c, &samples.tangent);
  for (const Eigen::Vector3d& tangent : samples.tangent) {
    samples.information.push_back(100 *
                                  (Eigen::Matrix3d::Identity() - tangent * tangent.transpose()));
  }
  return samples;
}

// `count` points at unit steps.
inline std::vector<Eigen::Vector3d> Row(const Eigen::Vector3d& begin, const Eigen::Vector3d& step,
                                        int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(begin + i * step);
  return points;
}

}  // namespace limn::testing
