#pragma once

#include "limn/drawing/draft.h"
#include "limn/support/view_evidence.h"

namespace limn {

// Edges too short for a fragment of their own (the thickness of a board, the height of a step): straight
// links between two nodes or free ends that are at most max_short_edge_px apart, where no link leaves in
// that direction yet, and edgels run along the segment in so many views that chance is no explanation.
// The samples of the new links are appended to `samples`, without a curve of the sketch. Returns the number
// of links added.
int64_t AddShortEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                      const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                      const DrawingOptions& options, SampleSet* samples, Draft* draft);

}  // namespace limn
