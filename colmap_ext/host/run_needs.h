// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/model/view.h"
#include "limn/tiles/tile_options.h"

namespace limn::colmap_ext {

// What a drawing needs, about: photographs with many edges need more, those with few less.
struct RunNeeds {
  double memory_bytes = 0;  // at its peak
  double cache_bytes = 0;   // in curves/cache
};

// By the number and size of the views, as they are drawn, and how many of them a tile has at most.
RunNeeds EstimateNeeds(const std::vector<View>& views, const TileOptions& tiles, int num_threads);

// What this process may still take: of the machine's memory, and of the limit of its group if it
// has one. Nothing where the system does not tell.
std::optional<double> AvailableMemory();

// A line that tells what a run needs and, if less memory is available, a warning that names what to
// do.
std::vector<std::string> LinesOf(const RunNeeds& needs, const std::optional<double>& available);

}  // namespace limn::colmap_ext
