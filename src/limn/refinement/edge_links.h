#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Per link, whether fits take it: all except the outlines of smooth bodies and the center lines of
// rods, which no edgels show.
inline std::vector<uint8_t> AreEdges(const DrawingGraph& graph) {
  std::vector<uint8_t> are_edges;
  for (const DrawingLink& link : graph.links) {
    are_edges.push_back(link.kind != LinkKind::kContour && link.kind != LinkKind::kRod);
  }
  return are_edges;
}

}  // namespace limn
