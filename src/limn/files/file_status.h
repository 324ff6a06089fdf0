// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace limn {

enum class FileKind { kFile, kFolder, kLink, kOther };

// The same for all names of one file, another for any other file that exists at the same time.
struct FileId {
  uint64_t device = 0;
  uint64_t number = 0;  // on the device

  auto operator<=>(const FileId&) const = default;
};

// As precise as the system keeps it.
struct FileTime {
  int64_t seconds = 0;  // since 1970
  int64_t nanoseconds = 0;
};

struct FileStatus {
  FileKind kind = FileKind::kOther;
  FileId id;
  FileTime changed;  // when its content last did
};

// These return nothing if there is no such file, or it cannot be looked at: errno says why.
// Of what a link leads to.
std::optional<FileStatus> StatusOfFile(const std::string& path);
std::optional<FileStatus> StatusOfOpenFile(int descriptor);
// Of what has this name in an open folder; of a link itself.
std::optional<FileStatus> StatusInFolder(int descriptor, const std::string& name);

}  // namespace limn
