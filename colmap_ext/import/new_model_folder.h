// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

#include "colmap_ext/model/model.h"
#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// Throws IoError if the folder exists and is not empty.
void CheckNewModelFolder(const std::filesystem::path& folder);

// Writes the files of a model (WriteModel) into a folder that must be new or
// empty (checked). They appear together or not at all: they are written to a folder of this name
// with kTemporarySuffix, which is then renamed. Missing parent folders are created. `write_more`
// may write further files into the folder. Throws IoError; then, and after AbandonWrites, only
// parent folders are left behind.
void WriteNewModel(const SparseModel& model, const std::filesystem::path& folder,
                   ModelFlavor flavor,
                   const std::function<void(const OutputPath&)>& write_more = {});

}  // namespace limn::colmap_ext
