// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/drawing/samples.h"
#include "limn/topology/topology_input.h"

namespace limn {

// The samples of the sketch at their places, all with the same weight: the input of the paper's
// drawing. Their information is 1 px across the curve; their support is the edgels of the sketch
// within the gate of `images`. Time: samples times supporting views.
SampleSet TakeSamples(const CurveSketch& sketch, const TopologyInput& images);

}  // namespace limn
