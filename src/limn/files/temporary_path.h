#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <system_error>

namespace limn {

// What is written under another name until it is whole: a file, or a folder with all that is in it.
// Removed at the end of its life, and by AbandonWrites, unless it has been renamed.
class TemporaryPath {
 public:
  // `make` makes it; what it throws passes through.
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

// Removes all temporary paths of other threads, which from now on wait forever where they make,
// rename or leave one: to be called right before the process exits without waiting for them.
void AbandonWrites();

// How many temporary paths have been renamed, to what is in no temporary folder. Also after
// AbandonWrites.
size_t NumRenamed();

}  // namespace limn
