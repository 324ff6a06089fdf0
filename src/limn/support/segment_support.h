// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"
#include "limn/support/view_edgels.h"

namespace limn {

// Chance is measured on copies of a curve, shifted sideways in the image by these distances, px:
// beyond the edge itself, within what surrounds it.
constexpr std::array<double, 6> kChanceShiftsPx = {-9, -7, -5, 5, 7, 9};
// Lower limit of the chance, since the copies sample little of the images.
constexpr double kMinChance = 0.02;

// Support of a straight edge in space by the images (algorithm/notation.md#segments-and-chance).
struct SegmentSupport {
  // Views in which edgels run along the segment.
  std::vector<ViewId> seen_in;
  // Views that could show it: both ends are in the image and the segment is not seen end on.
  int num_views = 0;
  // Chance that edgels run along such a segment in one view: the share of its copies, shifted
  // sideways, along which they do.
  double background = 0;
};

// Edgels run along a projected segment when at least `kMinCoveredShare` of its points, one per
// pixel and without the last 1.5 px at the ends, where edges are rounded, have one within the gate.
// Views with visible[v] = 0 are ignored.
SegmentSupport FindSegmentSupport(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const std::vector<uint8_t>& visible,
                                  const std::vector<View>& views,
                                  const std::vector<std::unique_ptr<ViewEdgels>>& edgels,
                                  const SupportGate& gate);

// Returns whether edgels run along the segment in this view, as above. False if an end is outside
// the image or the segment is seen end on.
bool ShowsSegment(const View& view, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  const EdgelIndex& edgels, const SupportGate& gate);

// Hoeffding's bound on the natural logarithm of the probability that k or more of n views show by
// accident what each of them shows with probability p; 0 if k does not exceed the expected number.
// Neighboring views are not independent trials, since accidents persist while the camera moves. So
// more than kIndependentViews views count as that many with the same share k / n. Fewer find fewer
// junctions, more believe accidents (algorithm/notation.md#what-was-measured).
constexpr int kIndependentViews = 18;
double LogChance(double k, double n, double p);

}  // namespace limn
