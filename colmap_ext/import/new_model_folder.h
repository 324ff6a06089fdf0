#pragma once

#include <filesystem>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

enum class ModelFlavor { kBinary, kText };

// Throws IoError unless there is no such folder yet, or an empty one.
void CheckNewModelFolder(const std::filesystem::path& folder);

// Write cameras, images and points3D into a folder that must be new or empty (checked). All three
// files appear together or none: they are written to "<folder>.tmp", which is then renamed. Missing
// parent folders are made. Throws IoError; then nothing is left but parent folders.
void WriteNewModel(const SparseModel& model, const std::filesystem::path& folder,
                   ModelFlavor flavor);

}  // namespace limn::colmap_ext
