#pragma once

#include "limn/drawing/samples.h"
#include "limn/topology/topology_input.h"

namespace limn {

// The samples of the sketch where it has them, each of the same weight: the input of the paper's
// drawing. Their information is one px across the curve, their support those of their edgels that
// are within max_support_distance_px. Time: samples times supporting views.
SampleSet TakeSamples(const CurveSketch& sketch, const TopologyInput& images);

}  // namespace limn
