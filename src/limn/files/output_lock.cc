// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/output_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLockFile = ".lock";
constexpr std::string_view kHolderBegins = "process ";

// Those of the folder and above it that are not there, inner ones first.
std::vector<OutputPath> MissingFolders(const OutputPath& folder) {
  std::vector<OutputPath> missing;
  for (OutputPath at = folder; !at.below().empty(); at = at.Folder()) {
    if (WritableFolder::Find(at)) return missing;
    missing.push_back(at);
  }
  std::error_code ignored;
  for (fs::path at = fs::absolute(folder.named()).lexically_normal();
       at.has_relative_path() && !fs::exists(at, ignored); at = at.parent_path()) {
    missing.push_back(at);
  }
  return missing;
}

// "process 123 on host" of this process.
std::string ThisProcess() {
  char host[256] = "";
  gethostname(host, sizeof(host) - 1);
  return std::string(kHolderBegins) + std::to_string(getpid()) + " on " + host;
}

// Empty while another process begins to write it.
std::string ReadHolder(int file) {
  char text[512];
  const ssize_t size = pread(file, text, sizeof(text), 0);
  return size > 0 ? std::string(text, static_cast<size_t>(size)) : "";
}

// Only what is said to others; the lock itself does not depend on it.
void WriteHolder(int file) {
  const std::string text = ThisProcess();
  if (ftruncate(file, 0) == 0) (void)!pwrite(file, text.data(), text.size(), 0);
}

struct LockFile {
  int file = -1;  // or errno says why not
  bool is_new = false;
};

// Whether its text may be replaced: it is empty, or says who holds the lock, and it has no other
// name, by which it may be somebody's.
bool IsLockFile(int file) {
  struct stat opened;
  if (fstat(file, &opened) != 0 || !S_ISREG(opened.st_mode) || opened.st_nlink > 1) return false;
  const std::string holder = ReadHolder(file);
  return holder.empty() || holder.starts_with(kHolderBegins);
}

// Makes or opens the file. A link is not followed: it may lead out of the workspace, to a file
// whose text would be lost. A pipe does not wait for its other end.
LockFile OpenLockFile(const WritableFolder& folder, const std::string& path) {
  constexpr int kFlags = O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
  int file = openat(folder.descriptor(), kLockFile, kFlags | O_CREAT | O_EXCL, 0666);
  if (file >= 0) return {file, true};
  if (errno == EEXIST) file = openat(folder.descriptor(), kLockFile, kFlags);
  if (file < 0 || IsLockFile(file)) return {file};
  close(file);
  throw IoError(path, "is not a lock file of limn, which is needed here: remove it");
}

// 0, or why not.
int LockOnce(int file, LockMode mode) {
  const int operation = mode == LockMode::kExclusive ? LOCK_EX : LOCK_SH;
  return flock(file, operation | LOCK_NB) == 0 ? 0 : errno;
}

// The same. One that ends and shared the lock has it for itself for a moment, to remove the file:
// others that share it wait for that.
int Lock(int file, LockMode mode) {
  int reason = LockOnce(file, mode);
  for (int i = 0; i < 100 && mode == LockMode::kShared && reason == EWOULDBLOCK; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    reason = LockOnce(file, mode);
  }
  return reason;
}

// Whether the open file is still the one in this folder, which may be another one by now.
bool IsIn(int file, const OutputPath& path) {
  const auto folder = WritableFolder::Find(path);
  const auto found = folder ? folder->StatusOf(kLockFile) : std::nullopt;
  const auto opened = StatusOfOpenFile(file);
  return found && opened && opened->id == found->id;
}

}  // namespace

OutputLock::OutputLock(const OutputPath& folder, LockMode mode) : folder_(folder) {
  do {
    for (OutputPath& made : MissingFolders(folder)) made_folders_.push_back(std::move(made));
  } while (!TryLock(mode));
  WriteHolder(file_);
}

std::string OutputLock::path() const { return (folder_ / kLockFile).string(); }

bool OutputLock::TryLock(LockMode mode) {
  const LockFile opened = OpenLockFile(WritableFolder::Make(folder_), path());
  file_ = opened.file;
  if (file_ < 0) {
    if (errno == ENOENT) return false;  // the folder, or the file that was there
    if (errno == ELOOP) RefuseLink(path());
    throw IoError(path(), std::string("cannot write: ") + std::strerror(errno));
  }
  const int reason = Lock(file_, mode);
  const bool locked = reason == 0;
  if (locked && IsIn(file_, folder_)) return true;
  const std::string holder = ReadHolder(file_);
  close(file_);
  file_ = -1;
  if (locked) return false;
  if (reason == EWOULDBLOCK) {
    throw IoError(path(), "in use by " + (holder.empty() ? "a process that is not known" : holder) +
                              ", which works on the same results: wait for it, or choose "
                              "another --output_path");
  }
  // A file that was there may be that of a process that could lock it.
  if (opened.is_new) RemoveWhatWasMade();
  throw IoError(path(), std::string("cannot be locked: ") + std::strerror(reason) +
                            ": choose an --output_path on a file system with flock");
}

void OutputLock::RemoveWhatWasMade() const {
  if (const auto folder = WritableFolder::Find(folder_)) folder->Remove(kLockFile);
  // Empty ones only.
  for (const OutputPath& made : made_folders_) {
    const auto above = WritableFolder::Find(made.Folder());
    if (above) above->RemoveEmptyFolder(made.Name());
  }
}

OutputLock::~OutputLock() {
  try {
    // The last one that shares the lock removes the file.
    if (flock(file_, LOCK_EX | LOCK_NB) == 0 && IsIn(file_, folder_)) RemoveWhatWasMade();
  } catch (const IoError&) {
    // Somebody has put something else in the place of the folder: the file is not there any more.
  }
  close(file_);
}

}  // namespace limn
