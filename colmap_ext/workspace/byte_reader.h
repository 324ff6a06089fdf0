#pragma once

#include <bit>
#include <cstdint>
#include <istream>
#include <string>
#include <type_traits>

#include "colmap_ext/workspace/model_builder.h"

namespace limn::colmap_ext {

static_assert(std::endian::native == std::endian::little, "COLMAP's files are little endian");

// Reads packed little-endian values and knows at any time where it is and how much is left. Every
// failure is an IoError with the byte offset.
class ByteReader {
 public:
  // `in` must be seekable; reading goes on from its current position. `path` is for messages.
  ByteReader(std::istream& in, std::string path);

  template <typename T>
  T Read(const char* what) {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    ReadBytes(&value, sizeof(T), what);
    return value;
  }
  void ReadBytes(void* out, uint64_t size, const char* what);

  // A u64 count of records of at least `min_record_bytes` each: fails if they cannot fit into what
  // is left of the file, so that it is safe to reserve.
  uint64_t ReadCount(const char* what, uint64_t min_record_bytes);

  // Up to a NUL, which is consumed; at most 4096 bytes.
  std::string ReadName(const char* what);

  // Fails unless everything has been read.
  void CheckEnd() const;

  uint64_t Offset() const { return offset_; }
  uint64_t Remaining() const { return size_ - offset_; }
  Place Here() const { return {path_, "byte", offset_}; }
  Place At(uint64_t offset) const { return {path_, "byte", offset}; }

 private:
  std::istream& in_;
  std::string path_;
  uint64_t offset_ = 0;
  uint64_t size_ = 0;
};

}  // namespace limn::colmap_ext
