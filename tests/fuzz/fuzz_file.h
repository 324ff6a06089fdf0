// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limn::fuzz {

// A file in memory for readers that open a path. Not on disk, gone with the object.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

// A folder of this process that is removed at its end.
const std::filesystem::path& ScratchFolder();

// Writes a file of that folder, for readers that look at names or at several files, and returns its
// path. Folders above it are made.
std::string WriteScratch(const std::string& name, std::string_view bytes);

// A path in it; for readers of files that only their writer can make (with a checksum).
std::string ScratchPath();

// First and last chunk of a PNG of 40 x 30 pixels: enough for readers of sizes.
std::string_view EmptyImage();

}  // namespace limn::fuzz
