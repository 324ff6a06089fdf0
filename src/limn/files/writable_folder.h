// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "limn/files/file_descriptor.h"
#include "limn/files/file_status.h"
#include "limn/files/output_path.h"

namespace limn {

// A folder, held open, in which files are made, renamed and removed. It is opened from the folder
// that the user named down, part by part and through no link: a link in the output folder leads no
// file elsewhere, not even one that is put there while Limn writes.
class WritableFolder {
 public:
  // Makes the folders that are missing. Throws IoError with the link, or what else is in the way.
  static WritableFolder Make(const OutputPath& folder);
  // The same without making any: nothing if a folder is missing.
  static std::optional<WritableFolder> Find(const OutputPath& folder);
  // The folder, or the nearest above that is there.
  static WritableFolder Nearest(const OutputPath& folder);

  const std::string& path() const { return path_; }
  // For openat and the like; reading needs another one.
  int descriptor() const { return descriptor_.number(); }

  // Of a link itself. Nothing if there is none of this name.
  std::optional<FileStatus> StatusOf(const std::string& name) const;
  // Without "." and "..", in any order. Empty if they cannot be read.
  std::vector<std::string> Names() const;
  // Of a folder in it; nothing if this is none, or a link.
  std::optional<WritableFolder> Enter(const std::string& name) const;

  // Why this user can make no file in it; no error if they can.
  std::error_code WhyNoFile() const;

  // Return no error, or why it is still there.
  std::error_code Remove(const std::string& name) const;  // a file or link
  std::error_code RemoveEmptyFolder(const std::string& name) const;
  std::error_code RemoveAll(const std::string& name) const;  // with all that is in it

 private:
  WritableFolder(FileDescriptor descriptor, std::string path)
      : descriptor_(std::move(descriptor)), path_(std::move(path)) {}
  // Opens as much of it as there is; `missing` receives the parts that are not.
  static WritableFolder Descend(const OutputPath& folder, std::vector<std::string>* missing);

  FileDescriptor descriptor_;
  std::string path_;
};

// Throws IoError that names the link and a way out.
[[noreturn]] void RefuseLink(const std::string& link);

// Throws IoError if a link is anywhere below this folder, which need not exist. Links of temporary
// names do not count.
void CheckHoldsNoLinks(const OutputPath& folder);

// Does nothing if there is none. Throws IoError.
void RemoveFile(const OutputPath& path);

}  // namespace limn
