// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// Samples of a curve, or of several back to back. All arrays are per sample.
struct SampleArrays {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> tangent;  // unit, along the curve
  // Inverse covariance of the position across the curve (zero along the tangent), world units.
  std::vector<Eigen::Matrix3d> information;
  // Pixel footprint: median over the supporting views (model/footprint.h).
  std::vector<double> footprint;

  int NumSamples() const { return static_cast<int>(position.size()); }
};

// Length of the curve through samples [begin, end), in footprints (px).
double LengthPx(const SampleArrays& samples, int begin, int end);

// Unit direction of a curve at its sample k: from the sample `reach` before it to the one `reach`
// after it, or to the curve's end. Zero if these are at one place.
Eigen::Vector3d DirectionAt(const std::vector<Eigen::Vector3d>& curve, bool closed, int k,
                            int reach);

// The run of sketch samples that a curve of the SampleSet comes from.
struct CurveOrigin {
  int sketch_curve = -1;
  int begin = 0;  // first sample
  ViewId primary_view = -1;
  bool closed = false;
  // Every `step`-th sample of the sketch was taken. It also stands for those up to the next one
  // taken; none is at `end` or beyond.
  int step = 1;
  int end = std::numeric_limits<int>::max();
};

// The samples of all curves, back to back: sample ids run through curve 0, then curve 1, and so on.
// All stages up to tracing or merging use these ids.
struct SampleSet : SampleArrays {
  std::vector<int> curve_begin = {0};  // one more than curves
  std::vector<CurveOrigin> origins;    // per curve
  std::vector<int> curve_of;           // per sample
  SupportLists support;

  int NumCurves() const { return static_cast<int>(origins.size()); }
  int Size(int curve) const { return curve_begin[curve + 1] - curve_begin[curve]; }
  // Ids and names of samples, whose curves are those of this set.
  int IdOf(const SketchSample& name) const { return curve_begin[name.curve] + name.sample; }
  SketchSample NameOf(int id) const { return {curve_of[id], id - curve_begin[curve_of[id]]}; }
  // The samples of the sketch that a sample stands for, as a run of one curve.
  LinkMember InSketch(int id) const;
};

// Lists the edgels that support the samples of a vertex, and turns the samples' names in the set
// into those in the sketch that they stand for.
void NameInSketch(const SampleSet& samples, LinkVertex* vertex);

// Appends samples [begin, end) of a curve to the set, as a curve.
void AppendCurve(const SampleArrays& curve, const SupportLists& support, int begin, int end,
                 const CurveOrigin& origin, SampleSet* samples);

// Reserves memory. Growing arrays would take up to three times their size.
void Reserve(size_t num_samples, size_t num_edgels, SampleSet* samples);

// The fates of the samples of the sketch: kDrawn for those that the set stands for, kLostSupport
// for the others.
SampleFates FatesOf(const CurveSketch& sketch, const SampleSet& samples);

// Arc length of each sample from the first of its curve, in footprints (px).
std::vector<double> ArcPx(const SampleSet& samples, int curve);

}  // namespace limn
