#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace limn {

// Appends numbers and arrays to a byte string, little-endian.
class ByteSink {
 public:
  template <typename T>
  void Put(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  // The number of elements, then the elements as they are in memory.
  template <typename T>
  void PutArray(std::span<const T> values) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
    Put(static_cast<uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void PutText(std::string_view text) { PutArray(std::span<const char>(text.data(), text.size())); }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Reads what ByteSink wrote. Throws IoError with path and byte where the data end too early.
class ByteSource {
 public:
  // `path` is for messages; `bytes` must outlive the source.
  ByteSource(std::string path, std::string_view bytes) : path_(std::move(path)), bytes_(bytes) {}

  template <typename T>
  T Get() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, Take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  template <typename T>
  std::vector<T> GetArray() {
    const size_t count = TakeCount(sizeof(T));
    const std::string_view taken = Take(count * sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), taken.data(), taken.size());
    return values;
  }
  std::string GetText();
  // A number of items of at least `item_size` bytes each that still fit into the file.
  size_t TakeCount(size_t item_size);

  std::string_view Rest() const { return bytes_.substr(position_); }
  // Throws IoError: damaged at the present byte.
  [[noreturn]] void Fail(const std::string& reason) const;
  // Throws unless all bytes were read.
  void ExpectEnd() const;

 private:
  std::string_view Take(size_t size);

  std::string path_;
  std::string_view bytes_;
  size_t position_ = 0;
};

}  // namespace limn
