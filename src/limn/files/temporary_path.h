#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <system_error>

namespace limn {

// A file or folder that is written under a temporary name until it is complete. Removed by the
// destructor, and by AbandonWrites, unless it has been renamed.
class TemporaryPath {
 public:
  // `make` creates it; its exceptions propagate.
  TemporaryPath(std::filesystem::path path,
                const std::function<void(const std::filesystem::path&)>& make);
  ~TemporaryPath();
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(const TemporaryPath&) = delete;

  const std::filesystem::path& path() const { return path_; }

  // Gives it its final name, in one step.
  std::error_code RenameTo(const std::filesystem::path& path);

 private:
  std::filesystem::path path_;
  bool is_renamed_ = false;
};

// Removes the temporary paths of all threads. From now on, other threads block forever when they
// create, rename or destroy one: call it right before the process exits without waiting for them.
void AbandonWrites();

// How many temporary paths have been renamed to paths outside temporary folders. Also valid after
// AbandonWrites.
size_t NumRenamed();

}  // namespace limn
