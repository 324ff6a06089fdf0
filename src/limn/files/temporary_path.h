// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <system_error>

#include "limn/files/output_path.h"
#include "limn/files/writable_folder.h"

namespace limn {

// A file or folder that is written under a temporary name until it is complete. Removed by the
// destructor, and by AbandonWrites, unless it has been renamed.
class TemporaryPath {
 public:
  // `make` creates it, with this name in this folder, which is made if it is missing. Throws
  // IoError; exceptions of `make` propagate.
  TemporaryPath(const OutputPath& path,
                const std::function<void(const WritableFolder&, const std::string&)>& make);
  ~TemporaryPath();
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(const TemporaryPath&) = delete;

  const OutputPath& path() const { return path_; }

  // Gives it its final name, in the same folder and in one step. Returns no error, or why it
  // cannot.
  std::error_code RenameTo(const std::string& name);
  // The same in the place of a folder of this name, which is removed: as soon as this object is.
  std::error_code Replace(const std::string& name);

 private:
  friend void AbandonWrites();
  std::error_code Rename(const std::string& from, const std::string& to) const;
  std::error_code ExchangeInSteps(const std::string& name) const;

  OutputPath path_;
  bool is_renamed_ = false;
  WritableFolder folder_;  // last: others see all of the object once it is made
};

// Makes an empty folder, for a TemporaryPath: whatever a killed run has left there is removed.
// Throws IoError.
void MakeEmptyFolder(const WritableFolder& folder, const std::string& name);

// Removes the temporary paths of all threads. From now on, other threads block forever when they
// create, rename or destroy one: call it right before the process exits without waiting for them.
void AbandonWrites();

// How many temporary paths have been renamed to paths outside temporary folders. Also valid after
// AbandonWrites.
size_t NumRenamed();

}  // namespace limn
