#pragma once

#include <optional>
#include <string>

#include "limn/model/view_sketch.h"

namespace limn {

// The sketch of one view on disk (see stage_file.h for the container and `identity`).
void WriteViewSketch(const std::string& path, const ViewSketch& sketch,
                     const std::string& identity);

// Nothing if the file was made from other input or by another version of Limn, and must be made
// again. An empty `identity` accepts any. Everything read is checked (ids of views below
// `num_views`, numbers finite except unknown sigmas); throws IoError.
std::optional<ViewSketch> ReadViewSketch(const std::string& path, int num_views,
                                         const std::string& identity);

}  // namespace limn
