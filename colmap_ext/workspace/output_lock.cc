#include "colmap_ext/workspace/output_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Makes the folder and those above it; returns those that were not there, inner ones first.
std::vector<fs::path> MakeFolders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = fs::absolute(folder).lexically_normal(); !fs::exists(at, error);
       at = at.parent_path()) {
    missing.push_back(at);
  }
  // Another process may remove a folder between a failed attempt to make it and the look at it.
  constexpr int kMaxAttempts = 100;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    fs::create_directories(folder, error);
    if (error != std::errc::file_exists) break;
  }
  if (error) throw IoError(folder.string(), "cannot create the folder: " + error.message());
  return missing;
}

// "process 123 on host" of this process.
std::string ThisProcess() {
  char host[256] = "";
  gethostname(host, sizeof(host) - 1);
  return "process " + std::to_string(getpid()) + " on " + host;
}

std::string ReadHolder(int file) {
  char text[512];
  const ssize_t size = pread(file, text, sizeof(text), 0);
  return size > 0 ? std::string(text, static_cast<size_t>(size)) : "a process that is not known";
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

// Makes or opens the file. A link is not followed: it may lead out of the workspace, to a file
// whose text would be lost. A pipe does not wait for its other end.
LockFile OpenLockFile(const fs::path& path) {
  constexpr int kFlags = O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
  int file = open(path.c_str(), kFlags | O_CREAT | O_EXCL, 0666);
  if (file >= 0) return {file, true};
  if (errno == EEXIST) file = open(path.c_str(), kFlags);
  struct stat opened;
  if (file < 0 || (fstat(file, &opened) == 0 && S_ISREG(opened.st_mode))) return {file};
  close(file);
  throw IoError(path.string(), "is not a regular file: remove it");
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

// Whether the open file is still the one at this path.
bool IsAt(int file, const fs::path& path) {
  struct stat opened, found;
  return fstat(file, &opened) == 0 && stat(path.c_str(), &found) == 0 &&
         opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

}  // namespace

OutputLock::OutputLock(const fs::path& folder, LockMode mode) : path_(folder / ".lock") {
  do {
    for (fs::path& made : MakeFolders(folder)) made_folders_.push_back(std::move(made));
  } while (!TryLock(mode));
  WriteHolder(file_);
}

bool OutputLock::TryLock(LockMode mode) {
  const LockFile opened = OpenLockFile(path_);
  file_ = opened.file;
  if (file_ < 0) {
    if (errno == ENOENT) return false;  // the folder, or the file that was there
    if (errno == ELOOP) throw IoError(path_.string(), "is a symbolic link: remove it");
    throw IoError(path_.string(), std::string("cannot write: ") + std::strerror(errno));
  }
  const int reason = Lock(file_, mode);
  const bool locked = reason == 0;
  if (locked && IsAt(file_, path_)) return true;
  const std::string holder = ReadHolder(file_);
  close(file_);
  file_ = -1;
  if (locked) return false;
  if (reason == EWOULDBLOCK) {
    throw IoError(path_.string(), "in use by " + holder +
                                      ", which works on the same results: wait for it, or choose "
                                      "another --output_path");
  }
  // A file that was there may be that of a process that could lock it.
  if (opened.is_new) RemoveWhatWasMade();
  throw IoError(path_.string(), std::string("cannot be locked: ") + std::strerror(reason) +
                                    ": choose an --output_path on a file system with flock");
}

void OutputLock::RemoveWhatWasMade() const {
  std::error_code ignored;
  fs::remove(path_, ignored);
  // Removes empty folders only.
  for (const fs::path& folder : made_folders_) rmdir(folder.c_str());
}

OutputLock::~OutputLock() {
  // The last one that shares the lock removes the file.
  if (flock(file_, LOCK_EX | LOCK_NB) == 0 && IsAt(file_, path_)) RemoveWhatWasMade();
  close(file_);
}

}  // namespace limn::colmap_ext
