// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "limn/util/byte_stream.h"

namespace limn {

// Many numbers of a kind in few bytes, without loss (algorithm/cache.md#packing).

namespace internal {

// Items of `item_bytes` each, as planes of their first bytes, their second bytes, and so on. A
// plane whose bytes repeat is deflated.
void PutPlanes(std::string_view items, size_t item_bytes, ByteWriter* out);
std::string GetPlanes(size_t num_items, size_t item_bytes, ByteReader* in);
// A count of packed items, checked to be possible for the remaining bytes.
size_t GetNumItems(ByteReader* in);

}  // namespace internal

// With their count.
template <typename T>
void PutPacked(const std::vector<T>& numbers, ByteWriter* out) {
  static_assert(std::is_arithmetic_v<T>);
  out->PutCount(numbers.size());
  internal::PutPlanes({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)},
                      sizeof(T), out);
}

// Throws IoError if the bytes are not those of packed numbers.
template <typename T>
std::vector<T> GetPacked(ByteReader* in) {
  static_assert(std::is_arithmetic_v<T>);
  const size_t count = internal::GetNumItems(in);
  const std::string items = internal::GetPlanes(count, sizeof(T), in);
  std::vector<T> numbers(count);
  if (count > 0) std::memcpy(numbers.data(), items.data(), items.size());
  return numbers;
}

// A text, deflated.
void PutPackedText(std::string_view text, ByteWriter* out);
std::string GetPackedText(ByteReader* in);

// Whole numbers in the order in which they follow each other closely: their steps, each in one byte
// if it is small.
class StepWriter {
 public:
  void Put(int64_t number) {
    const auto step =
        static_cast<int64_t>(static_cast<uint64_t>(number) - static_cast<uint64_t>(last_));
    last_ = number;
    PutUnsigned(static_cast<uint64_t>(step) << 1 ^ static_cast<uint64_t>(step >> 63));
  }
  void PutUnsigned(uint64_t number);
  // What follows is no step from the last number.
  void Restart(int64_t last = 0) { last_ = last; }
  void Finish(ByteWriter* out) const;

 private:
  std::string bytes_;
  int64_t last_ = 0;
};

class StepReader {
 public:
  explicit StepReader(ByteReader* in);
  int64_t Get();
  uint64_t GetUnsigned();
  void Restart(int64_t last = 0) { last_ = last; }
  // A count of items of at least one byte each.
  size_t GetCount();
  void ExpectEnd() const;

 private:
  ByteReader* in_;  // for messages
  std::string bytes_;
  size_t at_ = 0;
  int64_t last_ = 0;
};

}  // namespace limn
