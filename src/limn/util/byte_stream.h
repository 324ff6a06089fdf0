#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "limn/util/errors.h"

namespace limn {

static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");

// Appends numbers and strings to a buffer, little endian, without padding.
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

// Reads what a ByteWriter wrote and never beyond the end: throws IoError with path and byte.
class ByteReader {
 public:
  // The bytes must outlive the reader.
  ByteReader(std::string path, std::string_view bytes) : path_(std::move(path)), bytes_(bytes) {}

  template <typename T>
  T Get() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, Take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  // A count of items of at least `item_bytes` each, which the rest of the bytes can hold.
  size_t GetCount(size_t item_bytes) {
    const uint64_t count = Get<uint64_t>();
    if (count > (bytes_.size() - at_) / item_bytes) {
      Fail("count " + std::to_string(count) + " exceeds the file");
    }
    return count;
  }
  template <typename T>
  void GetArray(T* values, size_t count) {
    static_assert(std::is_arithmetic_v<T>);
    std::memcpy(values, Take(count * sizeof(T)).data(), count * sizeof(T));
  }
  std::string GetString() { return std::string(Take(GetCount(1))); }
  std::string_view Take(size_t count) {
    if (count > bytes_.size() - at_) Fail("the file ends too early");
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  size_t at() const { return at_; }
  // Throws unless everything has been read.
  void ExpectEnd() const {
    if (at_ != bytes_.size()) Fail("bytes left over");
  }
  [[noreturn]] void Fail(const std::string& reason) const {
    throw IoError(path_, "byte " + std::to_string(at_), reason);
  }
  void Check(bool ok, const char* reason) const {
    if (!ok) Fail(reason);
  }

 private:
  std::string path_;
  std::string_view bytes_;
  size_t at_ = 0;
};

}  // namespace limn
