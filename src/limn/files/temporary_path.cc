// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/temporary_path.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>

#include <sys/stat.h>

#include "limn/files/call_error.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// The temporary paths of all writes in progress.
struct OpenWrites {
  std::mutex mutex;
  std::set<TemporaryPath*> paths;
  std::atomic<size_t> num_renamed = 0;
};

OpenWrites& Writes() {
  // Never destroyed: a thread may write while the process ends.
  static OpenWrites* const writes = new OpenWrites;
  return *writes;
}

WritableFolder MakeIn(const OutputPath& path,
                      const std::function<void(const WritableFolder&, const std::string&)>& make) {
  WritableFolder folder = WritableFolder::Make(path.Folder());
  make(folder, path.Name());
  return folder;
}

}  // namespace

// Even the folder is made while no other thread can abandon all writes.
TemporaryPath::TemporaryPath(
    const OutputPath& path,
    const std::function<void(const WritableFolder&, const std::string&)>& make)
    : path_(path), folder_([&] {
        const std::lock_guard lock(Writes().mutex);
        WritableFolder folder = MakeIn(path, make);
        Writes().paths.insert(this);
        return folder;
      }()) {}

TemporaryPath::~TemporaryPath() {
  if (!is_renamed_) folder_.RemoveAll(path_.Name());
  const std::lock_guard lock(Writes().mutex);
  Writes().paths.erase(this);
}

std::error_code TemporaryPath::RenameTo(const std::string& name) {
  const std::lock_guard lock(Writes().mutex);
  if (const std::error_code error = Rename(path_.Name(), name)) return error;
  is_renamed_ = true;
  // What is in a temporary folder is not a result yet.
  const bool is_inside = std::ranges::any_of(Writes().paths, [&](const TemporaryPath* other) {
    return other->path().string() == folder_.path();
  });
  if (!is_inside) ++Writes().num_renamed;
  return {};
}

std::error_code TemporaryPath::Replace(const std::string& name) {
  const std::lock_guard lock(Writes().mutex);
  const int folder = folder_.descriptor();
  // From now on the old one has the temporary name.
  if (renameat2(folder, path_.Name().c_str(), folder, name.c_str(), RENAME_EXCHANGE) != 0) {
    if (errno != EINVAL && errno != ENOSYS) return {errno, std::generic_category()};
    if (const std::error_code error = ExchangeInSteps(name)) return error;
  }
  ++Writes().num_renamed;
  return {};
}

// Where the file system cannot exchange names. A kill in between leaves the old one as <name>.old.
std::error_code TemporaryPath::ExchangeInSteps(const std::string& name) const {
  const std::string old = name + ".old";
  if (const std::error_code error = Rename(name, old)) return error;
  if (const std::error_code error = Rename(path_.Name(), name)) {
    Rename(old, name);
    return error;
  }
  Rename(old, path_.Name());
  return {};
}

std::error_code TemporaryPath::Rename(const std::string& from, const std::string& to) const {
  const int folder = folder_.descriptor();
  return ErrorOf(renameat(folder, from.c_str(), folder, to.c_str()));
}

void MakeEmptyFolder(const WritableFolder& folder, const std::string& name) {
  folder.RemoveAll(name);
  if (mkdirat(folder.descriptor(), name.c_str(), 0777) == 0) return;
  throw IoError(folder.path() + "/" + name,
                std::string("cannot create the folder: ") + std::strerror(errno));
}

void AbandonWrites() {
  // Locked for good: no write may begin or end any more.
  Writes().mutex.lock();
  // Again if another thread makes a file in the folder meanwhile.
  constexpr int kMaxTimes = 100;
  for (const TemporaryPath* temporary : Writes().paths) {
    if (temporary->is_renamed_) continue;
    for (int i = 0; i < kMaxTimes; ++i) {
      const std::error_code error = temporary->folder_.RemoveAll(temporary->path_.Name());
      if (!error || error == std::errc::no_such_file_or_directory) break;
    }
  }
}

size_t NumRenamed() { return Writes().num_renamed; }

}  // namespace limn
