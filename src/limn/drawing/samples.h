#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/curve3d.h"

namespace limn {

// The run of sketch samples that a curve of the SampleSet comes from.
struct CurveOrigin {
  int sketch_curve = -1;
  int begin = 0;  // first sample
  ViewId anchor_view = -1;
  bool closed = false;
};

// The samples of all curves, back to back: sample ids run through curve 0, then curve 1, and so on.
// All stages up to merging use these ids.
struct SampleSet {
  std::vector<int> curve_begin = {0};  // one more than curves
  std::vector<CurveOrigin> origins;    // per curve
  std::vector<int> curve_of;           // per sample
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> tangent;  // unit, along the curve
  // Inverse covariance of the position across the curve (zero along the tangent), world units.
  std::vector<Eigen::Matrix3d> information;
  // Pixel footprint: median over the supporting views (model/footprint.h).
  std::vector<double> footprint;
  SupportLists support;

  int NumCurves() const { return static_cast<int>(origins.size()); }
  int NumSamples() const { return static_cast<int>(position.size()); }
  int Size(int curve) const { return curve_begin[curve + 1] - curve_begin[curve]; }
};

// Reserves memory. Growing arrays would take up to three times their size.
void Reserve(size_t num_samples, size_t num_edgels, SampleSet* samples);

// Arc length of each sample from the first of its curve, in footprints (px).
std::vector<double> ArcPx(const SampleSet& samples, int curve);

}  // namespace limn
