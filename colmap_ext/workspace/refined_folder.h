#pragma once

#include <filesystem>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// The folder refined/ beside a drawing: a model with refined cameras, and limn.txt, which has the
// sizes and hashes of its files. By it limn knows the files that it wrote, if nobody has changed
// them: binary files of a model have no place for a mark.

// Call it before the work. Throws IoError if a file there could not be replaced, or, unless
// `overwrite`, is not limn's. Files of both flavors count: all of them will be replaced.
void CheckRefinedFolder(const std::filesystem::path& folder, bool overwrite);

// Writes the model in its flavor, each file atomically, and removes all other files of a model.
// Precondition: CheckRefinedFolder. Throws IoError, and what CheckTextNames throws.
void WriteRefinedFolder(const SparseModel& model, const std::filesystem::path& folder);

// Removes what limn wrote there, and the folder if it is empty then. Returns whether no file of a
// model is left. Throws IoError.
bool RemoveRefinedFolder(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
