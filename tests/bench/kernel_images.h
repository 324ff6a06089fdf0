// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include "limn/model/edge_map.h"
#include "limn/model/image.h"

namespace limn::bench {

// A photograph of the sample scene, read once.
const Image& SamplePhotograph();

// Its edgels by default options, found once.
const EdgeMap& SampleEdgels();

// Items are megapixels of the photograph; `s_per_MP` is the CPU time for one.
void ReportPerMegapixel(benchmark::State& state);

}  // namespace limn::bench
