// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Per link, whether fits take it.
inline std::vector<uint8_t> AreEdges(const DrawingGraph& graph) {
  std::vector<uint8_t> are_edges;
  for (const DrawingLink& link : graph.links) are_edges.push_back(link.IsAlongEdgels());
  return are_edges;
}

}  // namespace limn
