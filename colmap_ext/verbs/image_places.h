// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/workspace/to_views.h"
#include "limn/alignment/image_point.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// The places of a drawing that photographs show at pixels. `stored` are the views of the set, of
// images as stored (InStoredImages), that the drawing fits. Throws InputError as SnapToDrawing, and
// for an image that the set does not have.
std::vector<DrawingPlace> PlacesOf(const std::vector<ImagePoint>& points, const ViewSet& set,
                                   const std::vector<View>& stored, const DrawingGraph& graph);

}  // namespace limn::colmap_ext
