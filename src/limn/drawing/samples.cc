// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/samples.h"

#include <algorithm>
#include <cmath>

#include "limn/util/sort_unique.h"

namespace limn {

double LengthPx(const SampleArrays& samples, int begin, int end) {
  double length_px = 0;
  for (int s = begin + 1; s < end; ++s) {
    length_px += (samples.position[s] - samples.position[s - 1]).norm() / samples.footprint[s];
  }
  return length_px;
}

Eigen::Vector3d DirectionAt(const std::vector<Eigen::Vector3d>& curve, bool closed, int k,
                            int reach) {
  const int size = static_cast<int>(curve.size());
  const int before = closed ? (k + size - reach) % size : std::max(k - reach, 0);
  const int after = closed ? (k + reach) % size : std::min(k + reach, size - 1);
  return (curve[after] - curve[before]).normalized();
}

LinkMember SampleSet::InSketch(int id) const {
  const CurveOrigin& origin = origins[curve_of[id]];
  const int begin = origin.begin + origin.step * NameOf(id).sample;
  return {origin.sketch_curve, begin, std::min(begin + origin.step, origin.end)};
}

void NameInSketch(const SampleSet& samples, LinkVertex* vertex) {
  std::vector<EdgelRef>& edgels = vertex->support;
  std::vector<SketchSample> in_sketch;
  for (const SketchSample& sample : vertex->samples) {
    const int id = samples.IdOf(sample);
    const auto support = samples.support.Of(id);
    edgels.insert(edgels.end(), support.begin(), support.end());
    const LinkMember run = samples.InSketch(id);
    for (int s = run.begin; s < run.end; ++s) in_sketch.push_back({run.curve, s});
  }
  vertex->samples = std::move(in_sketch);
  SortUnique(&edgels);
}

void AppendCurve(const SampleArrays& curve, const SupportLists& support, int begin, int end,
                 const CurveOrigin& origin, SampleSet* samples) {
  samples->curve_of.resize(samples->curve_of.size() + end - begin, samples->NumCurves());
  samples->origins.push_back(origin);
  for (int s = begin; s < end; ++s) {
    samples->position.push_back(curve.position[s]);
    samples->tangent.push_back(curve.tangent[s]);
    samples->information.push_back(curve.information[s]);
    samples->footprint.push_back(curve.footprint[s]);
    samples->support.Append(support.Of(s));
  }
  samples->curve_begin.push_back(samples->NumSamples());
}

void Reserve(size_t num_samples, size_t num_edgels, SampleSet* samples) {
  samples->curve_of.reserve(num_samples);
  samples->position.reserve(num_samples);
  samples->tangent.reserve(num_samples);
  samples->information.reserve(num_samples);
  samples->footprint.reserve(num_samples);
  samples->support.offsets.reserve(num_samples + 1);
  samples->support.edgels.reserve(num_edgels);
}

std::vector<double> ArcPx(const SampleSet& samples, int curve) {
  const int begin = samples.curve_begin[curve];
  std::vector<double> arc(samples.Size(curve), 0.0);
  for (size_t k = 1; k < arc.size(); ++k) {
    const int i = begin + static_cast<int>(k);
    arc[k] = arc[k - 1] + (samples.position[i] - samples.position[i - 1]).norm() /
                              (0.5 * (samples.footprint[i] + samples.footprint[i - 1]));
  }
  return arc;
}

SampleFates FatesOf(const CurveSketch& sketch, const SampleSet& samples) {
  SampleFates fates;
  for (const Curve3D& curve : sketch.curves) {
    fates.emplace_back(curve.size(), EdgelFate::kLostSupport);
  }
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const LinkMember run = samples.InSketch(s);
    std::fill_n(fates[run.curve].begin() + run.begin, run.size(), EdgelFate::kDrawn);
  }
  return fates;
}

}  // namespace limn
