// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/folder_search.h"

#include <algorithm>
#include <limits>
#include <system_error>

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxEntriesBelow = 200'000;

// At most `max` of them; unsorted beyond.
std::vector<fs::directory_entry> SortedListing(const fs::path& folder, size_t max) {
  std::vector<fs::directory_entry> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end && entries.size() < max;
       it.increment(error)) {
    entries.push_back(*it);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

FolderSearch SearchFolder(const fs::path& folder, int depth, size_t max_entries) {
  FolderSearch found;
  found.folders = {folder};
  size_t num_seen = 0;
  size_t begin = 0;
  for (int level = 0; level <= depth && begin < found.folders.size(); ++level) {
    const size_t end = found.folders.size();
    for (; begin < end; ++begin) {
      const fs::path current = found.folders[begin];
      for (const fs::directory_entry& entry : SortedListing(current, max_entries - num_seen)) {
        ++num_seen;
        std::error_code ignored;
        if (entry.is_regular_file(ignored)) {
          found.files.push_back(entry.path());
        } else if (level < depth && entry.is_directory(ignored) && !entry.is_symlink(ignored) &&
                   !entry.path().filename().string().starts_with(".")) {
          found.folders.push_back(entry.path());
        }
      }
    }
  }
  return found;
}

std::vector<std::string> FilesBelow(const fs::path& folder) {
  std::vector<std::string> files;
  constexpr int kAnyDepth = std::numeric_limits<int>::max();
  for (const fs::path& file : SearchFolder(folder, kAnyDepth, kMaxEntriesBelow).files) {
    files.push_back(file.lexically_relative(folder).string());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace limn::colmap_ext
