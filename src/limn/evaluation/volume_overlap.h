// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/evaluation/edge_solids.h"
#include "limn/util/parallel.h"

namespace limn {

// How much of two unions of solids is common.
struct VolumeOverlap {
  // Of the first union, the second one and what is in both; in the unit of the solids, cubed.
  double first = 0, second = 0, common = 0;
  // By how much the share changed when the lines were last made twice as dense in both directions.
  double share_change = 0;

  // Intersection over union; 0 if both are empty.
  double Share() const;
};

// Measures it with parallel lines in a fixed direction that no usual edge has, whose chords in each
// solid are exact: their spacing is an eighth of the largest radius, then half of that, and so on
// until the share changes by no more than `max_change`, or until this would take more than 4e8
// chords; share_change tells. The result depends neither on the order of the solids nor on which
// union is the first, nor on the number of threads, and the share of equal unions is 1. Throws
// InputError if the solids are too long for their radius (1e8 chords at first) or too far apart
// (1e14 lines), and Cancelled. O(n log n) in the number of chords, which is that of lines through
// each solid; memory for the rows of each solid, and for a row of lines per thread.
VolumeOverlap MeasureOverlap(const std::vector<EdgeSolid>& first,
                             const std::vector<EdgeSolid>& second, double max_change,
                             const RunContext& context = {});

}  // namespace limn
