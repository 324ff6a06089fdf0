#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_options.h"

namespace limn {

struct TidyCounts {
  int64_t forks_cut = 0;  // ends freed that left a node alongside another link
  int64_t dissolved_nodes = 0;
  int64_t samples_short = 0;    // of the sketch, in links that were too short
  int64_t samples_covered = 0;  // and in links that ran along another
};

// Tidy a drawing until nothing changes: forks are cut, nodes in which two links meet alone and go
// on smoothly dissolve, links that run along others and short links that hang by one end or by none
// are removed. Every link must have vertices. O(n log n) in the number of points.
TidyCounts Tidy(const TopologyOptions& options, GraphEditor* editor);

// The steps of Tidy.

// Free the ends of links that leave a node together with another link, turning away from it by less
// than min_junction_angle_deg: merging leaves such forks where two strands of one edge, or two
// parallel edges, part slowly. Edges do not meet so. Of such a pair the link stays that goes on
// best into a third link of the node, or else the longer one. Returns the number of ends freed.
int64_t CutForks(const TopologyOptions& options, GraphEditor* editor);

// Two links that are alone at a node and go on in each other become one. Returns their number.
int64_t DissolveNodes(const TopologyOptions& options, GraphEditor* editor);

// Remove links shorter than min_link_length_px that hang by one end or by none. Links between two
// nodes may be short, and those that grew from a node (without samples of the sketch). Returns the
// number of samples of the sketch in them.
int64_t RemoveShortLinks(const TopologyOptions& options, GraphEditor* editor);

}  // namespace limn
