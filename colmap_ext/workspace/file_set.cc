// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/file_set.h"

#include <optional>

namespace limn::colmap_ext {

FileSet::FileSet(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (const auto file = StatusOfFile(path)) files_.insert(file->id);
  }
}

bool FileSet::Contains(const std::string& path) const {
  const auto file = StatusOfFile(path);
  return file && files_.contains(file->id);
}

}  // namespace limn::colmap_ext
