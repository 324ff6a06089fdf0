// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <type_traits>

#include "limn/util/errors.h"

namespace limn {

static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");

// Appends numbers and strings to a buffer, little-endian, without padding.
class ByteWriter {
 public:
  template <typename T>
  void Put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.append(raw, sizeof(T));
  }
  void PutCount(size_t count) { Put<uint64_t>(count); }
  void PutString(std::string_view text) {
    PutCount(text.size());
    bytes_.append(text);
  }
  // Without their count.
  template <typename T>
  void PutArray(const T* values, size_t count) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Reads packed little-endian values from memory or from a file, and never beyond the end. Every
// failure is an IoError with the path and the byte. `what` names a value in the message.
class ByteReader {
 public:
  // The bytes must outlive the reader. `path` is for messages.
  ByteReader(std::string path, std::string_view bytes);
  // From the current position of a seekable stream, which must outlive the reader. Reads ahead in
  // blocks.
  ByteReader(std::string path, std::istream& in);
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  template <typename T>
  T Get(const char* what = "a value") {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    CopyTo(&value, sizeof(T), what);
    return value;
  }
  // A byte that must be 0 or 1.
  bool GetFlag() {
    const uint8_t flag = Get<uint8_t>("a flag");
    Check(flag <= 1, "a flag is neither 0 nor 1");
    return flag == 1;
  }
  // A count of items of at least `item_bytes` each, checked to fit in the remaining bytes, so that
  // reserving memory is safe.
  size_t GetCount(size_t item_bytes);
  template <typename T>
  void GetArray(T* values, size_t count, const char* what = "an array") {
    static_assert(std::is_trivially_copyable_v<T>);
    CopyTo(values, count * sizeof(T), what);
  }
  std::string GetString() { return std::string(Take(GetCount(1))); }
  // The next bytes. For a stream, valid until the next call.
  std::string_view Take(size_t count);

  // Bytes read so far, and remaining.
  uint64_t at() const { return at_; }
  uint64_t Remaining() const { return size_ - at_; }
  // Throws unless everything has been read.
  void ExpectEnd() const;

  FilePlace Here() const { return At(at_); }
  FilePlace At(uint64_t byte) const { return {path_, "byte", byte}; }
  [[noreturn]] void Fail(const std::string& reason) const { Here().Fail(reason); }
  void Check(bool ok, const char* reason) const {
    if (!ok) Fail(reason);
  }

 private:
  void CopyTo(void* out, size_t count, const char* what) {
    if (count == 0) return;
    if (count > window_.size()) return CopyAcross(out, count, what);
    std::memcpy(out, window_.data(), count);
    Advance(count);
  }
  // The same beyond the end of the window.
  void CopyAcross(void* out, size_t count, const char* what);
  void Advance(size_t count) {
    window_.remove_prefix(count);
    at_ += count;
  }
  void ExpectBytes(uint64_t count, const char* what) const;
  // Extends the window to `count` bytes. Precondition: the stream has them.
  void Refill(size_t count, const char* what);
  void ReadStream(char* out, size_t count, const char* what);

  std::string path_;
  std::istream* in_ = nullptr;  // null: all bytes are in the window
  std::string buffer_;          // storage of the window of a stream
  std::string_view window_;     // the next bytes
  uint64_t at_ = 0;
  uint64_t size_ = 0;
};

}  // namespace limn
