// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/host/project.h"

namespace limn::colmap_ext {

// Edges and fragments in files for other programs, which --edges_path reads back exactly:
// <curves>/edges/<image name>.edg and <curves>/fragments/<image name>.cem, in pixels of the images
// as used.
enum class EdgeFormat { kNone, kEdg, kCem };

// Call it before the work: throws IoError if the files of a format would replace a file that the
// project reads edges from, something that is not a regular file or, unless `overwrite`, a file
// that limn did not write.
void CheckEdgeResults(const Project& project, EdgeFormat format, bool overwrite);

// Writes the file of a view, before ApplyLens. Thread-safe for different views.
void WriteEdgResult(const Project& project, ViewId view, EdgeMap edge_map);

// The same for fragments, as an observer of ExtractImageCurves. The project must outlive it.
FragmentsObserver CemWriter(const Project& project);

// Prints where the files of a format are.
void SayEdgeResults(const Project& project, EdgeFormat format, Console* console);

}  // namespace limn::colmap_ext
