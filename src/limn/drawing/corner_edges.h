#pragma once

#include "limn/drawing/draft.h"
#include "limn/support/view_evidence.h"

namespace limn {

// Edges that begin at a corner and are too short, or too broken in the images, for the sketch: the height of
// a step, the thickness of a board. At every joint (a node or a free end) the image edges that point at its
// projection, and that no link of the joint explains, are collected as rays; rays of two views give a
// direction in space, which is believed when rays of so many other views agree that chance is no
// explanation. The edge then grows as far as edgels support it, ends at a joint that it reaches, and becomes
// a link. Its samples are appended to `samples`, without a curve of the sketch. Returns the number of links
// added.
int64_t GrowCornerEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                        const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                        const DrawingOptions& options, SampleSet* samples, Draft* draft);

}  // namespace limn
