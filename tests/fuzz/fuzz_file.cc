// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

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

const std::filesystem::path& ScratchFolder() {
  static const TempDir dir;
  return dir.path();
}

std::string WriteScratch(const std::string& name, std::string_view bytes) {
  const std::filesystem::path path = ScratchFolder() / name;
  std::ofstream out(path, std::ios::binary);
  if (!out) {
    std::filesystem::create_directories(path.parent_path());
    out.open(path, std::ios::binary);
  }
  out << bytes;
  out.close();
  if (!out) {
    std::perror(path.c_str());
    std::abort();
  }
  return path.string();
}

std::string ScratchPath() { return (ScratchFolder() / "fuzzed.bin").string(); }

std::string_view EmptyImage() {
  using namespace std::string_view_literals;
  return "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x28\0\0\0\x1e\x08\0\0\0\0????"
         "\0\0\0\0IEND????"sv;
}

}  // namespace limn::fuzz
