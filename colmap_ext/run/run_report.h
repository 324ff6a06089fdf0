#pragma once

#include <vector>

#include "colmap_ext/run/console.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/run/truth_input.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

// Writes drawing.html with the report of the run: counts, times and memory of its stages, warnings,
// options that differ from the defaults, links by number of supporting views; with a truth
// precision and recall, and both again for the links of at least so many views. The graph and
// `views`, the cameras that it fits, are around the project's origin. Says so where limn was built
// without the page. Throws IoError.
void WritePageWithReport(const Project& project, const RunOptions& options,
                         const std::vector<View>& views, const DrawingGraph& graph,
                         const TruthInput& truth, Console* console);

}  // namespace limn::colmap_ext
