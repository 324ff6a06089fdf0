#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Per link, whether fits take it: all except the outlines of smooth bodies.
inline std::vector<uint8_t> AreEdges(const DrawingGraph& graph) {
  std::vector<uint8_t> are_edges;
  for (const DrawingLink& link : graph.links) are_edges.push_back(link.kind != LinkKind::kContour);
  return are_edges;
}

}  // namespace limn
