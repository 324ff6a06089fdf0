#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limn {

// 64-bit FNV-1a hash of a stream of bytes: tells whether two contents are the same, no protection
// against intent.
class ContentHash {
 public:
  void Add(std::string_view bytes) {
    for (const char byte : bytes) {
      state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    }
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
