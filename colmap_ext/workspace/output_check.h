#pragma once

#include <filesystem>

namespace limn::colmap_ext {

// Throws IoError unless files can be made in this folder, or the folder itself can. Nothing is
// written: to be called before hours of work.
void CheckWritable(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
