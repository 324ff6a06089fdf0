// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/file_status.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace limn {
namespace {

FileKind KindOfMode(mode_t mode) {
  if (S_ISREG(mode)) return FileKind::kFile;
  if (S_ISDIR(mode)) return FileKind::kFolder;
  if (S_ISLNK(mode)) return FileKind::kLink;
  return FileKind::kOther;
}

FileStatus FileStatusFrom(const struct stat& status) {
  return {KindOfMode(status.st_mode),
          {status.st_dev, status.st_ino},
          {status.st_mtim.tv_sec, status.st_mtim.tv_nsec}};
}

}  // namespace

std::optional<FileStatus> StatusOfFile(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileStatusFrom(status);
}

std::optional<FileStatus> StatusOfOpenFile(int descriptor) {
  struct stat status = {};
  if (fstat(descriptor, &status) != 0) return std::nullopt;
  return FileStatusFrom(status);
}

std::optional<FileStatus> StatusInFolder(int descriptor, const std::string& name) {
  struct stat status = {};
  if (fstatat(descriptor, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return std::nullopt;
  return FileStatusFrom(status);
}

}  // namespace limn
