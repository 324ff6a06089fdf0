// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "limn/files/file_status.h"

namespace limn::colmap_ext {

// Existing files by identity, not by name: a link to a file counts as that file.
class FileSet {
 public:
  // Paths that do not exist are left out.
  explicit FileSet(const std::vector<std::string>& paths);

  // False if there is no such file. Logarithmic time.
  bool Contains(const std::string& path) const;

 private:
  std::set<FileId> files_;
};

}  // namespace limn::colmap_ext
