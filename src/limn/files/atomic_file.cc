// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limn/files/file_buffer.h"
#include "limn/files/temporary_path.h"
#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxNameBytes = 255;

[[noreturn]] void FailToWrite(const OutputPath& path, const std::string& reason) {
  throw IoError(path.string(), "cannot write: " + reason);
}

// Several processes may write the same file at the same time, on several hosts. The name does not
// contain that of the file, which may be as long as names can be.
std::string TemporaryName() {
  thread_local std::random_device device;
  std::string name;
  for (int i = 0; i < 2; ++i) {
    for (unsigned rest = device(), k = 0; k < 8; ++k, rest >>= 4) {
      name += "0123456789abcdef"[rest & 15];
    }
  }
  return name.append(kTemporarySuffix);
}

// A new file with the owner and permissions of the one that will be replaced, if there is one; or
// errno says why not.
FileDescriptor OpenNew(const WritableFolder& folder, const std::string& temporary,
                       const std::string& name) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  FileDescriptor file(openat(folder.descriptor(), temporary.c_str(), kFlags, 0666));
  if (!file.IsOpen()) return file;
  struct stat old = {};
  const bool has_old = fstatat(folder.descriptor(), name.c_str(), &old, AT_SYMLINK_NOFOLLOW) == 0 &&
                       S_ISREG(old.st_mode);
  if (!has_old) return file;
  // Only root may give files away.
  (void)!fchown(file.number(), old.st_uid, old.st_gid);
  (void)!fchmod(file.number(), old.st_mode & 0777);
  return file;
}

// /dev/stdout may lead to a regular file, but stands among devices.
bool IsAmongDevices(const fs::path& named) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(named, ignored);
  return folder == "/dev" || folder.string().starts_with("/proc/");
}

bool LeadsToDevice(const WritableFolder& folder, const std::string& name) {
  struct stat status = {};
  if (fstatat(folder.descriptor(), name.c_str(), &status, 0) != 0) return false;
  return !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

// Throws IoError unless this is nothing, or a file to replace.
void CheckReplaced(const OutputPath& path) {
  const auto folder = WritableFolder::Find(path.Folder());
  std::optional<FileStatus> there;
  if (folder) there = folder->StatusOf(path.Name());
  const auto is = [&](FileKind kind) { return there.has_value() && there->kind == kind; };
  if (is(FileKind::kFolder)) FailToWrite(path, "is a folder, not a file");
  if (IsAmongDevices(path.named()) || (there && LeadsToDevice(*folder, path.Name()))) {
    FailToWrite(path, "is a device or a pipe, or leads to one, and no file");
  }
  if (is(FileKind::kLink)) RefuseLink(path.string());
}

}  // namespace

void CheckTakesFile(const OutputPath& path) {
  if (path.Name().empty()) FailToWrite(path, "is a folder, not a file");
  if (path.Name().size() > kMaxNameBytes) {
    FailToWrite(path, "the name of the file is longer than 255 bytes");
  }
  WritableFolder::Nearest(path.Folder());  // throws
  CheckReplaced(path);
}

void WriteFileAtomically(const OutputPath& path, const std::function<void(std::ostream&)>& write) {
  CheckTakesFile(path);
  FileDescriptor file;
  TemporaryPath temporary(path.Folder() / TemporaryName(),
                          [&](const WritableFolder& folder, const std::string& name) {
                            file = OpenNew(folder, name, path.Name());
                            if (!file.IsOpen()) FailToWrite(path, std::strerror(errno));
                          });
  FileBuffer buffer(std::move(file));
  std::ostream out(&buffer);
  // An exception at the first byte that cannot be written: the reason is still in errno, and the
  // rest is not made in vain.
  out.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    errno = 0;
    write(out);
    if (!buffer.Close()) out.setstate(std::ios::badbit);
  } catch (const std::ios_base::failure&) {
    FailToWrite(path, std::strerror(errno));
  }
  if (const std::error_code error = temporary.RenameTo(path.Name())) {
    FailToWrite(path, error.message());
  }
}

void WriteFileAtomically(const OutputPath& path, std::string_view bytes) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace limn
