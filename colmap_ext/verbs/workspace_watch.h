// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "colmap_ext/host/project.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// A snapshot of the files that a drawing is made from: those of the model's folder, and the images
// and masks.
class WorkspaceWatch {
 public:
  explicit WorkspaceWatch(std::filesystem::path model_dir);

  // Takes the snapshot. Call it before the files are read, so that no change is missed.
  void Look();
  // Watches the images of this project from now on.
  void WatchImages(const Project& project, const std::filesystem::path& mask_dir);

  bool HasChanged() const { return Now() != seen_; }
  // Returns when a file has changed and none has for two seconds; false if the run is cancelled.
  bool WaitForChange(const RunContext& context) const;

 private:
  // Size and time; those of a missing file are zero.
  using Stamp = std::pair<uintmax_t, std::filesystem::file_time_type>;
  using Stamps = std::map<std::filesystem::path, Stamp>;

  Stamps Now() const;

  std::filesystem::path model_dir_;
  std::set<std::filesystem::path> images_;
  Stamps seen_;
};

}  // namespace limn::colmap_ext
