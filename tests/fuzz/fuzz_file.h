#pragma once

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

// A path in a folder of this process that is removed at its end; for readers of files that only
// their writer can make (with a checksum).
std::string ScratchPath();

}  // namespace limn::fuzz
