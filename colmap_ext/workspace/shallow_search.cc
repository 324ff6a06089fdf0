#include "colmap_ext/workspace/shallow_search.h"

#include <algorithm>
#include <system_error>

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxSeen = 20000;

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

ShallowSearch SearchShallow(const fs::path& folder, int depth) {
  ShallowSearch found;
  found.folders = {folder};
  size_t num_seen = 0;
  size_t begin = 0;
  for (int level = 0; level <= depth && num_seen < kMaxSeen; ++level) {
    const size_t end = found.folders.size();
    for (; begin < end && num_seen < kMaxSeen; ++begin) {
      const fs::path current = found.folders[begin];
      for (const fs::directory_entry& entry : SortedListing(current, kMaxSeen - num_seen)) {
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

}  // namespace limn::colmap_ext
