// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "colmap_ext/model/model.h"
#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// The folder refined/ beside a drawing: a model with refined cameras, and limn.txt, which has the
// sizes and hashes of its files. By it limn knows the files that it wrote, if nobody has changed
// them: binary files of a model have no place for a mark.

constexpr const char* kRefinedFolder = "refined";

// Call it before the work. Throws IoError if a file there could not be replaced, or, unless
// `overwrite`, is not limn's. Files of both flavors count: all of them will be replaced.
void CheckRefinedFolder(const OutputPath& folder, bool overwrite);

// Writes the model in its flavor, each file atomically, and removes all other files of a model.
// Returns its NameOfRefinedCameras. Precondition: CheckRefinedFolder. Throws IoError, and what
// CheckTextNames throws.
std::string WriteRefinedFolder(const SparseModel& model, const OutputPath& folder);

// Removes what limn wrote there, and the folder if it is empty then. Returns whether no file of a
// model is left. Throws IoError.
bool RemoveRefinedFolder(const OutputPath& folder);

// A name of the cameras of a model, by names, poses and parameters, for the results that fit them.
// Empty if the folder has no model, or a damaged one.
std::string NameOfRefinedCameras(const std::filesystem::path& folder);

// The name of those that a drawing.json or the file of a sketch (.bin) fits. Empty if it fits none.
std::string RefinedCamerasOf(const std::filesystem::path& result);

}  // namespace limn::colmap_ext
