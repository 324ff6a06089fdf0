#pragma once

#include <string>

#include "colmap_ext/commands/console.h"
#include "colmap_ext/commands/project.h"
#include "colmap_ext/commands/run_options.h"
#include "colmap_ext/commands/truth_input.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

// The report of a run for the page (limn/viewer/), as JSON: counts, times and memory of its stages,
// warnings, options that differ from the defaults, links by number of supporting views; with a
// truth precision and recall, and both again for the links of at least so many views. `graph` and
// `views` are in the model's coordinates.
std::string RunReportJson(const Project& project, const RunOptions& options,
                          const DrawingGraph& graph, const std::vector<View>& views,
                          const TruthInput& truth, const Console& console);

}  // namespace limn::colmap_ext
