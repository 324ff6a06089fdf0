#include "fuzz/fuzz_file.h"

#include <cstdio>
#include <cstdlib>

#include <sys/mman.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"

namespace limn::fuzz {

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzzed", 0)) {
  if (descriptor_ < 0 ||
      write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    std::perror("memory file");
    std::abort();
  }
  path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

MemoryFile::~MemoryFile() { close(descriptor_); }

std::string ScratchPath() {
  static const TempDir dir;
  return (dir / "fuzzed.bin").string();
}

}  // namespace limn::fuzz
