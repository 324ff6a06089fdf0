#include "limn/files/temporary_path.h"

#include <atomic>
#include <mutex>
#include <set>
#include <utility>

namespace limn {
namespace {

namespace fs = std::filesystem;

// The temporary paths of all writes in progress.
struct OpenWrites {
  std::mutex mutex;
  std::set<fs::path> paths;
  std::atomic<size_t> num_renamed = 0;
};

OpenWrites& Writes() {
  // Never destroyed: a thread may write while the process ends.
  static OpenWrites* const writes = new OpenWrites;
  return *writes;
}

// Again if another thread makes a file in the folder meanwhile.
void RemoveFromOthers(const fs::path& path) {
  constexpr int kMaxTimes = 100;
  std::error_code error;
  fs::remove_all(path, error);
  for (int i = 1; i < kMaxTimes && error; ++i) fs::remove_all(path, error);
}

}  // namespace

TemporaryPath::TemporaryPath(fs::path path, const std::function<void(const fs::path&)>& make)
    : path_(std::move(path)) {
  const std::lock_guard lock(Writes().mutex);
  make(path_);
  Writes().paths.insert(path_);
}

TemporaryPath::~TemporaryPath() {
  std::error_code ignored;
  if (!is_renamed_) fs::remove_all(path_, ignored);
  const std::lock_guard lock(Writes().mutex);
  Writes().paths.erase(path_);
}

std::error_code TemporaryPath::RenameTo(const fs::path& path) {
  const std::lock_guard lock(Writes().mutex);
  std::error_code error;
  fs::rename(path_, path, error);
  is_renamed_ = !error;
  // What is in a temporary folder is not a result yet.
  if (is_renamed_ && !Writes().paths.contains(path.parent_path())) ++Writes().num_renamed;
  return error;
}

void AbandonWrites() {
  // Locked for good: no write may begin or end any more.
  Writes().mutex.lock();
  for (const fs::path& path : Writes().paths) RemoveFromOthers(path);
}

size_t NumRenamed() { return Writes().num_renamed; }

}  // namespace limn
