#pragma once

#include <vector>

#include "limn/model/edge_map.h"

namespace limn {

// An ordered chain of edgels of one image. Never smoothed or resampled: fragment vertex = edgel,
// because support is counted in edgels.
struct CurveFragment {
  std::vector<EdgelId> edgel_ids;
  // The last edgel is followed by the first one (which is not repeated).
  bool closed = false;
};

// An undirected link of the linker's graph: the two edgels are neighbors in `votes` curvelets.
struct EdgelLink {
  EdgelId a = kInvalidEdgel;  // a < b
  EdgelId b = kInvalidEdgel;
  int votes = 0;
};

// The curves of one image: input of every multi-view stage.
struct ImageCurves {
  EdgeMap edge_map;
  std::vector<CurveFragment> fragments;
  // The whole link graph, sorted by (a, b). It includes links that no fragment uses.
  std::vector<EdgelLink> link_graph;
};

}  // namespace limn
