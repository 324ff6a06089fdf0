// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/sketch_samples.h"

#include <cmath>

#include "limn/model/footprint.h"

namespace limn {
namespace {

double FootprintOf(const Curve3D& curve, size_t s, const std::vector<View>& views) {
  std::vector<ViewId> supporting;
  for (const EdgelRef& ref : curve.support.Of(s)) supporting.push_back(ref.view);
  const double footprint = MedianFootprint(curve.points_in_world[s], supporting, views);
  return footprint > 0 ? footprint : PixelFootprint(views, curve.points_in_world[s]);
}

// The edgels of each sample that are within the gate of the drawing, its own included.
SupportLists NearSupport(const Curve3D& curve, const TopologyInput& images) {
  SupportLists near;
  std::vector<EdgelRef> of_sample;
  for (size_t s = 0; s < curve.size(); ++s) {
    of_sample.clear();
    for (const EdgelRef& ref : curve.support.Of(s)) {
      const auto residual = images.Residual(ref, curve.points_in_world[s]);
      if (residual && std::abs(residual->residual_px) <= images.gate.normal_px) {
        of_sample.push_back(ref);
      }
    }
    near.Append(of_sample);
  }
  return near;
}

SampleArrays ArraysOf(const Curve3D& curve, const std::vector<View>& views) {
  SampleArrays arrays;
  arrays.position = curve.points_in_world;
  arrays.tangent = curve.tangents_in_world;
  for (size_t s = 0; s < curve.size(); ++s) {
    const double footprint = FootprintOf(curve, s, views);
    const Eigen::Vector3d& tangent = curve.tangents_in_world[s];
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
    arrays.footprint.push_back(footprint);
    arrays.information.push_back(across / (footprint * footprint));
  }
  return arrays;
}

}  // namespace

SampleSet TakeSamples(const CurveSketch& sketch, const TopologyInput& images) {
  SampleSet samples;
  for (size_t c = 0; c < sketch.curves.size(); ++c) {
    const Curve3D& curve = sketch.curves[c];
    if (curve.size() < 2) continue;
    AppendCurve(ArraysOf(curve, images.views), NearSupport(curve, images), 0,
                static_cast<int>(curve.size()),
                {static_cast<int>(c), 0, curve.anchor.view, curve.closed}, &samples);
  }
  return samples;
}

}  // namespace limn
