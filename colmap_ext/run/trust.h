#pragma once

#include <vector>

#include "colmap_ext/run/console.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Prints how far the drawing can be believed: how much of the images it explains, the share of its
// length that many views see, and its expected error. Warns of a drawing that explains next to
// nothing, of views that agree with it much less than the others, and of those without edges.
// `views` are those that the drawing fits; without `curves` (a scene in tiles) nothing is said of
// single views. With a box, drawings may explain little.
void SayTrust(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
              const DrawingGraph& graph, bool has_box, Console* console);

}  // namespace limn::colmap_ext
