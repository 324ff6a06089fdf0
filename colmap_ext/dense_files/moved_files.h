// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limn/files/output_path.h"
#include "limn/geometry/similarity3.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// What became of the cloud and the meshes of a dense workspace.
struct MovedFiles {
  std::vector<std::string> names;     // of those that were written
  std::vector<std::string> left_out;  // why others were not: a line each, with the path
};

// Whether there is such a file in a folder.
bool HasDenseFiles(const std::filesystem::path& folder);

// Writes what there is in `from` of fused.ply and meshed-*.ply to the folder `to`, moved (MovePly),
// with this comment in their headers, and fused.ply.vis as it is. Damaged ones are left out. Throws
// IoError for what cannot be written, and Cancelled.
MovedFiles MoveDenseFiles(const std::filesystem::path& from, const Similarity3d& similarity,
                          const std::string& comment, const OutputPath& to,
                          const RunContext& context);

}  // namespace limn::colmap_ext
