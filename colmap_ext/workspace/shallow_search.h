#pragma once

#include <filesystem>
#include <vector>

namespace limn::colmap_ext {

struct ShallowSearch {
  std::vector<std::filesystem::path> files;    // regular files
  std::vector<std::filesystem::path> folders;  // the first is that of the search
};

// What is in a folder and up to `depth` below, near before deep, then by name. Links to folders are
// not followed, hidden folders and what cannot be listed are left out, and at most 20,000 entries
// are seen.
ShallowSearch SearchShallow(const std::filesystem::path& folder, int depth);

}  // namespace limn::colmap_ext
