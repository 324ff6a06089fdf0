// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/whole_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include <zlib.h>

#include "limn/util/errors.h"
#include "limn/util/lower_case.h"

namespace limn {

void CheckIsFile(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(there)) throw IoError(path, "is a folder, not a file");
  if (std::filesystem::is_other(there)) throw IoError(path, "is a pipe or a device, not a file");
}

std::ifstream OpenFile(const std::string& path) {
  CheckIsFile(path);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, "cannot be opened for reading");
  return in;
}

namespace {

// Text packs to a twentieth of its size at best.
constexpr uint64_t kSmallUnpackedBytes = uint64_t{1} << 26;
constexpr uint64_t kMaxUnpackedRatio = 100;

std::string ReadBytes(const std::string& path, uint64_t max_bytes) {
  CheckIsFile(path);
  errno = 0;
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
  if (!file) throw IoError(path, std::string("cannot open: ") + std::strerror(errno));
  const uint64_t size_on_disk = std::filesystem::file_size(path);
  if (size_on_disk > max_bytes) {
    throw IoError(path, "has " + std::to_string(size_on_disk) + " bytes, at most " +
                            std::to_string(max_bytes) + " are read");
  }
  max_bytes = std::min(max_bytes, std::max(kSmallUnpackedBytes, kMaxUnpackedRatio * size_on_disk));
  std::string bytes;
  constexpr unsigned kBlock = 1 << 16;
  while (true) {
    if (bytes.size() > max_bytes) {
      throw IoError(path, "does not end after " + std::to_string(max_bytes) + " bytes");
    }
    const size_t old_size = bytes.size();
    bytes.resize(old_size + kBlock);
    const int count = gzread(file.get(), bytes.data() + old_size, kBlock);
    if (count < 0) {
      int code = 0;
      throw IoError(path, "byte " + std::to_string(old_size), gzerror(file.get(), &code));
    }
    bytes.resize(old_size + count);
    if (count == 0) break;
  }
  int code = Z_OK;
  const char* reason = gzerror(file.get(), &code);
  // Only this distinguishes a truncated gzip file from a whole one.
  if (code != Z_OK) throw IoError(path, "byte " + std::to_string(bytes.size()), reason);
  return bytes;
}

}  // namespace

std::string ReadWholeFile(const std::string& path, uint64_t max_bytes) {
  try {
    return ReadBytes(path, max_bytes);
  } catch (const std::bad_alloc&) {
    throw IoError(path, "is too large for the memory");
  }
}

std::string FileExtension(const std::string& file) {
  std::filesystem::path path(file);
  if (path.extension() == ".gz") path = path.stem();
  return LowerCase(path.extension().string());
}

}  // namespace limn
