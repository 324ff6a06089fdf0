// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/files/output_path.h"

namespace limn {

// Whether other processes may use a folder at the same time: none, or those that share the lock.
enum class LockMode { kExclusive, kShared };

// A lock (flock) on the file `.lock` in a folder of results, during the lifetime of the object.
// The system releases it when the process ends in any way, so a file left by a killed process means
// nothing. Works across hosts if the file system supports it (NFS does).
class OutputLock {
 public:
  // Creates the folder (see WritableFolder). Throws IoError if something other than a lock file of
  // limn is in the place of the file (links are not followed), or, with the file and the process
  // that holds the lock, if it cannot be acquired at once (a shared one: within a second), or where
  // the file system has no flock.
  OutputLock(const OutputPath& folder, LockMode mode);
  // Removes the files it created if no other process holds the lock.
  ~OutputLock();
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

 private:
  std::string path() const;
  // False if another process removed the file in the meantime.
  bool TryLock(LockMode mode);
  // The file, and the folders that were created for it if they are empty.
  void RemoveWhatWasMade() const;

  OutputPath folder_;
  std::vector<OutputPath> made_folders_;  // inner ones first
  int file_ = -1;
};

}  // namespace limn
