// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/curve_topology.h"

namespace limn {

// The curves to search, and which ends count as the same node.
struct AlongsideSearch {
  const CurveSamples& samples;
  const CurveTopology& topology;
  // Per node, the representative of its group (GroupNodes).
  const std::vector<int>& node_groups;
};

// Whether another curve runs alongside the sample: its nearest approach is within `radius`, and its
// direction there is within 30 degrees of the sample's. Curves that merely meet end to end are not
// alongside: an approach that is nearest at the other curve's end does not count when that end is
// at a node of the sample's own curve. `scratch` is a buffer. Throws InputError if the radius
// covers more than 4,000 samples of one curve.
bool RunsAlongsideAnother(const AlongsideSearch& search, int sample, double radius,
                          std::vector<SpatialIndex::Neighbor>* scratch);

// Nodes connected by polylines shorter than scale_of(polyline) share a representative (the smallest
// index): a chain of pieces shorter than the tolerance is one place.
std::vector<int> GroupNodes(const std::vector<Polyline3d>& polylines, const CurveTopology& topology,
                            const std::function<double(const Polyline3d&)>& scale_of);

}  // namespace limn
