// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

struct ReliabilityOptions {
  // A drawn place is right within this distance of the truth: in world units, or in pixel
  // footprints if there are views.
  double tau = 2;
  // Places within this many taus of a don't-care curve do not count.
  double dont_care_taus = 2;
  // Only what is inside counts.
  std::optional<Eigen::AlignedBox3d> region;
};

// Drawn length with similar confidences.
struct ReliabilityBin {
  double length = 0;  // world units
  // Length expected to be right by the confidences, and length that is.
  double told = 0;
  double right = 0;
};
constexpr int kNumReliabilityBins = 10;

// Confidences of links against the truth. Bin b has confidences from b / 10 to (b + 1) / 10.
struct Reliability {
  double tau = 0;
  std::array<ReliabilityBin, kNumReliabilityBins> bins = {};

  double Length() const;
  // Expected calibration error: the mean over the length of | told - right | / length of the bins;
  // 0 if there is no length.
  double CalibrationError() const;
};

// Of all links that have a confidence, tentative or not, but outlines, of rods too, and center
// lines (Naeini, Cooper and Hauskrecht, "Obtaining well calibrated probabilities using Bayesian
// binning", 2015). Throws OptionError and Cancelled. Time: length over tau, times the number of
// views and the logarithm of the length of the truth.
Reliability CompareConfidences(const DrawingGraph& drawing, const CurveSet& truth,
                               const CurveSet& dont_care, const std::vector<View>& views,
                               const ReliabilityOptions& options, const RunContext& context);

// The table as text: of every bin with length, its share of it, what was told and what is right.
void PrintReliability(const Reliability& reliability, std::ostream& out);

}  // namespace limn
