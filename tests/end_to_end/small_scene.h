// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "colmap_ext/temp_dir.h"

namespace limn::testing {

// The main job on some small images of the sample scene, into one folder.
class SmallScene {
 public:
  explicit SmallScene(int num_images = 6);

  std::filesystem::path output() const { return dir_ / "out"; }
  std::filesystem::path operator/(const std::string& name) const { return output() / name; }
  std::vector<std::string> Arguments(const std::vector<std::string>& more = {}) const;

 private:
  TempDir dir_;
  std::string list_;
};

// The files below a folder, but the page, whose report has times.
std::map<std::string, std::string> Results(const std::filesystem::path& folder);

// The same without the options of the run, which name its folder.
std::map<std::string, std::string> ResultsOfRun(const std::filesystem::path& folder);

// Those of the main job on a SmallScene in one go.
std::map<std::string, std::string> ResultsInOneGo();

// Of all files together.
size_t NumBytes(const std::map<std::string, std::string>& files);

// What a run may leave beside results: nothing; the file of its lock, if it ended in a hurry; and
// temporary files too, if it was killed.
enum class Leftovers { kNone, kLock, kLockAndSketches, kAll };

// The names of files that are not those of a whole run with these results, or have other bytes; the
// page must end.
std::vector<std::string> WrongFiles(const std::filesystem::path& folder,
                                    const std::map<std::string, std::string>& whole_run,
                                    Leftovers allowed);

}  // namespace limn::testing
