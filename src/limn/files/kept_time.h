// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/files/output_path.h"
#include "limn/files/writable_folder.h"

namespace limn {

// The time of change of a file, for a new one that replaces it.
class KeptTime {
 public:
  // Throws IoError if there is no such file.
  explicit KeptTime(const OutputPath& path);

  // Of the file that has replaced it. Throws IoError.
  void Restore() const;

 private:
  FileTime ChangeOfFile() const;
  [[noreturn]] void Fail() const;

  OutputPath path_;
  WritableFolder folder_;
  FileTime changed_;
};

}  // namespace limn
