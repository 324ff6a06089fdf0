#pragma once

#include <cstdint>

#include "limn/refinement/graph_editor.h"

namespace limn {

struct TopologyEditCounts {
  int64_t trimmed = 0;   // free ends that ran along another link
  int64_t joined = 0;    // pairs of free ends that continue each other
  int64_t to_nodes = 0;  // free ends taken to a node, and to the inside of a link
  int64_t to_links = 0;
  int64_t corners = 0;  // places where links turned sharply
};

// What a fit to the images makes visible of a drawing's topology, put right so that the next fit
// can use it: the four edits below in their order. Gaps of more than a few pixels are closed only
// where edgels run along them. The graph passes Validate() before and after. O(n log n) in the
// length of all links, px, times views for the gaps.
TopologyEditCounts EditTopology(GraphEditor* editor);

// Free ends that run along another link are cut back to where they part from it; links of which
// little remains are removed. Returns the number of ends cut.
int64_t TrimEnds(GraphEditor* editor);

// Free ends that face each other on one line become one link, or close a loop. Returns the number
// of pairs.
int64_t JoinAlignedEnds(GraphEditor* editor);

// Free ends whose line passes through a node or the inside of another link, and not along it, end
// there.
struct SnapCounts {
  int64_t to_nodes = 0;
  int64_t to_links = 0;
};
SnapCounts SnapEnds(GraphEditor* editor);

// Links are cut where they turn sharply between straight arms, so that the fit does not round the
// corner. Returns the number of cuts.
int64_t SplitAtCorners(GraphEditor* editor);

}  // namespace limn
