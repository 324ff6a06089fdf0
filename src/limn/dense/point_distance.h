// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/dense/drawing_samples.h"

namespace limn {

// Per sample 1 if a point of the cloud is within `near_px` of its footprints. Reads the cloud once;
// time per point: logarithmic in the samples.
std::vector<uint8_t> FindSamplesNearPoints(const DrawingSamples& samples,
                                           const DensePointStream& points, double near_px);

}  // namespace limn
