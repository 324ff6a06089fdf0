#pragma once

#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/trust.h"
#include "colmap_ext/verbs/truth_input.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

// Writes drawing.html with the report of the run: counts, times and memory of its stages, warnings,
// options that differ from the defaults, how far to trust the drawing, links by number of
// supporting images; with a truth also precision and recall, overall and for the links with at
// least n of them. The graph and `views`, the cameras that it fits, are relative to the
// project's origin. Prints a line if Limn was built without the page. Throws IoError.
void WritePageWithReport(const Project& project, const RunOptions& options,
                         const std::vector<View>& views, const DrawingGraph& graph,
                         const Trust& trust, const TruthInput& truth, Console* console);

}  // namespace limn::colmap_ext
