// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/curve_topology.h"
#include "limn/evaluation/evaluation_options.h"
#include "limn/evaluation/true_chains.h"
#include "limn/model/curve_set.h"
#include "limn/util/parallel.h"

namespace limn {

// What EvaluateCurves compares, and how.
struct EvaluationScene {
  const CurveSet& reconstruction;
  const CurveSet& truth;
  const CurveSet& dont_care;
  const EvaluationOptions& options;
  // Local unit of length at a point: 1 for world units.
  const std::function<double(const Eigen::Vector3d&)>& unit_at;
  const RunContext& context;
  CurveTopology topology;  // of the reconstruction
  bool in_footprints = false;

  bool InRegion(const Eigen::Vector3d& point) const {
    return !options.region || options.region->contains(point);
  }
};

// The same cut into samples for one tau.
struct SampledScene {
  const EvaluationScene& scene;
  double tau = 0;
  const CurveSamples& reconstruction;
  const CurveSamples& truth;
  const CurveSamples& dont_care;

  // `taus` times tau in world units there.
  double Radius(double taus, const Eigen::Vector3d& point) const {
    return taus * tau * scene.unit_at(point);
  }
  bool IsIgnored(const Eigen::Vector3d& point) const {
    return dont_care.Distance(point) < Radius(scene.options.dont_care_taus, point);
  }
  // Whether a place of the reconstruction counts.
  bool Counts(const Eigen::Vector3d& point) const {
    return scene.InRegion(point) && !IsIgnored(point);
  }
};

// Runs body(sample) for 0..count-1 in parallel.
void ForEachSample(const RunContext& context, int count, const std::function<void(int)>& body);

}  // namespace limn
