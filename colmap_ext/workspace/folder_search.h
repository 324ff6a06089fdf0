// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limn::colmap_ext {

struct FolderSearch {
  std::vector<std::filesystem::path> files;    // regular files
  std::vector<std::filesystem::path> folders;  // the first is that of the search
};

// What is in a folder and up to `depth` below, near before deep, then by name. Links to folders are
// not followed, hidden folders and what cannot be listed are left out, and at most `max_entries`
// are seen.
FolderSearch SearchFolder(const std::filesystem::path& folder, int depth,
                          size_t max_entries = 20'000);

// Paths of the files at any depth, relative to the folder and sorted; at most 200,000 entries are
// seen.
std::vector<std::string> FilesBelow(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
