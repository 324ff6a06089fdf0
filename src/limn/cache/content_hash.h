// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace limn {

// 64-bit FNV-1a hash of a stream of bytes, to detect changed content; not cryptographic.
class ContentHash {
 public:
  void Add(std::string_view bytes) {
    for (const char byte : bytes) {
      state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    }
  }

  // With its length, so that "ab", "c" and "a", "bc" differ.
  void AddText(std::string_view text) {
    AddNumber(text.size());
    Add(text);
  }

  template <typename T>
  void AddNumber(T number) {
    static_assert(std::is_arithmetic_v<T>);
    char raw[sizeof(T)];
    std::memcpy(raw, &number, sizeof(T));
    Add({raw, sizeof(T)});
  }

  // Eight bytes at once, for many numbers; differs from hashing the same bytes one by one.
  void AddWord(uint64_t word) {
    // A product carries upwards only.
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15ULL;
    state_ = (state_ ^ state_ >> 32) * 0xd6e8feb86659fd93ULL;
    state_ ^= state_ >> 32;
  }
  void AddWord(double number) { AddWord(std::bit_cast<uint64_t>(number)); }

  // With their count.
  template <typename T>
  void AddNumbers(const std::vector<T>& numbers) {
    AddNumber(numbers.size());
    for (const T number : numbers) AddNumber(number);
  }

  // 16 hexadecimal digits.
  std::string Hex() const {
    std::string text(16, '0');
    uint64_t rest = state_;
    for (int i = 15; i >= 0; --i, rest >>= 4) text[i] = "0123456789abcdef"[rest & 15];
    return text;
  }

 private:
  uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace limn
