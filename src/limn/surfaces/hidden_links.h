// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// The links that the drawing's faces hide from most of the views that show them, ascending (ours;
// algorithm/surfaces.md#links-behind-faces): more than half of the samples in supporting views are
// more than 5 px behind a face. Either the link or the face is false. Links that bound faces,
// tentative ones and outlines are not judged. Time: views times (triangles plus samples).
std::vector<LinkId> LinksBehindFaces(const std::vector<View>& views, const DrawingGraph& graph,
                                     const RunContext& context);

}  // namespace limn
