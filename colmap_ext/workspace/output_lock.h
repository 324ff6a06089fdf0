#pragma once

#include <filesystem>
#include <vector>

namespace limn::colmap_ext {

// Who may work in a folder of curves beside this process: nobody, or others that share it too.
enum class LockMode { kExclusive, kShared };

// A lock (flock) on the file `.lock` in the folder of curves, for as long as the object lives. The
// system takes it away with the process, however that ends: a file that a killed process has left
// means nothing. Works between hosts where the file system does (NFS: yes).
class OutputLock {
 public:
  // Makes the folder. Throws IoError, naming the file and the process that is at work, if the lock
  // cannot be had at once (within a second where it is to be shared).
  OutputLock(const std::filesystem::path& folder, LockMode mode);
  // Removes the file if no other process holds it, and the folders that were made for it if they
  // are still empty.
  ~OutputLock();
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

 private:
  // False if another process has removed the file in the meantime.
  bool TryLock(LockMode mode);

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_folders_;  // inner ones first
  int file_ = -1;
};

}  // namespace limn::colmap_ext
