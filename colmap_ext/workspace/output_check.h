#pragma once

#include <filesystem>

namespace limn::colmap_ext {

// Throws IoError unless files can be created in this folder, or the folder itself can. Writes
// nothing; to be called before a long run.
void CheckWritable(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
