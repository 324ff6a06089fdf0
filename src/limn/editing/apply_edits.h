// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "limn/editing/edit_outcome.h"
#include "limn/editing/edits.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/topology/topology_options.h"

namespace limn {

struct EditedDrawing {
  DrawingGraph graph;
  // Per link: its shape has changed, so it must be fitted to the images again.
  std::vector<uint8_t> touched;
  // Per link: its kind was set by hand.
  std::vector<uint8_t> kind_by_hand;
  // Per dimension: added by these edits.
  std::vector<uint8_t> new_dimension;
  std::vector<EditOutcome> outcomes;  // per edit
  std::vector<BridgedGap> gaps;
  size_t num_dropped_faces = 0;  // all or none
};

// Whether any link must be fitted to the images again.
bool HasTouched(const EditedDrawing& edited);

// Applies edits in their order. An edit that does not fit the drawing changes nothing, and its
// outcome says so. The graph passes Validate() before and after; links that are not touched keep
// their shape, and all links their order. Faces stay only if all links are still there with their
// shapes. `views` are those that the drawing was made from, at least one; `topology` has the gaps
// and angles of ends that meet and continue each other. Time: n log n in the length of all links in
// px, and the lengths of all references.
EditedDrawing ApplyEdits(const DrawingGraph& graph, const std::vector<View>& views,
                         const std::vector<Edit>& edits, const TopologyOptions& topology);

// Moves the places of dimensions onto the refitted links: those of new dimensions to the nearest
// link, others only if that link was touched. Within reach of an end they go to the end.
void SnapDimensions(const std::vector<View>& views, EditedDrawing* edited);

}  // namespace limn
