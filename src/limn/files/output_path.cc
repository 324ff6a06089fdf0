// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/output_path.h"

namespace limn {

namespace fs = std::filesystem;

OutputPath::OutputPath(fs::path named, fs::path below)
    : named_(std::move(named)), below_(std::move(below)), text_((named_ / below_).string()) {}

OutputPath OutputPath::operator+(std::string_view ending) const {
  fs::path longer = below_;
  longer += ending;
  return {named_, std::move(longer)};
}

std::pair<fs::path, fs::path> OutputPath::Split(const fs::path& path) {
  const fs::path name = path.filename();
  if (name == "." || name == "..") return {path, {}};
  return {path.parent_path(), name};
}

}  // namespace limn
