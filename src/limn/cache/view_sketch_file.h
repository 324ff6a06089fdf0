#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/cache/curve3d_bytes.h"
#include "limn/model/view_sketch.h"

namespace limn {

// Stores the sketch of one view (see stage_file.h for the container and `identity`).
void WriteViewSketch(const std::string& path, const ViewSketch& sketch,
                     const std::string& identity);

// Nothing if the file is stale: made from other input or by another version of Limn. An empty
// `identity` accepts any. `view` was sketched. Views are numbered as when it was written.
// Everything read is checked (anchors in the view, ids in range, a fate for each of its edgels,
// numbers finite except unknown sigmas); throws IoError.
std::optional<ViewSketch> ReadViewSketch(const std::string& path, ViewId view,
                                         const CurvesOfViews& curves, const std::string& identity);

}  // namespace limn
