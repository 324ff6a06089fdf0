// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/printable.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace limn {
namespace {

struct Range {
  uint32_t first, last;
};

// Unicode's categories Cc, Cf, Zl and Zp.
constexpr Range kUnprintable[] = {
    {0x0, 0x1F},        {0x7F, 0x9F},       {0xAD, 0xAD},       {0x600, 0x605},
    {0x61C, 0x61C},     {0x6DD, 0x6DD},     {0x70F, 0x70F},     {0x890, 0x891},
    {0x8E2, 0x8E2},     {0x180E, 0x180E},   {0x200B, 0x200F},   {0x2028, 0x202E},
    {0x2060, 0x2064},   {0x2066, 0x206F},   {0xFEFF, 0xFEFF},   {0xFFF9, 0xFFFB},
    {0x110BD, 0x110BD}, {0x110CD, 0x110CD}, {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3},
    {0x1D173, 0x1D17A}, {0xE0001, 0xE0001}, {0xE0020, 0xE007F}};

bool IsPrintable(uint32_t code) {
  const auto range = std::ranges::lower_bound(kUnprintable, code, {}, &Range::last);
  return range == std::end(kUnprintable) || code < range->first;
}

// A character of UTF-8, or a byte that belongs to none.
struct Character {
  uint32_t code = 0;
  size_t num_bytes = 0;  // 0: of none
};

// The character that the text begins with. Neither longer than needed nor a half of a surrogate.
Character FirstOf(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return {};
  uint32_t code = byte(0) & (0x7F >> size);
  for (size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_half = code >= 0xD800 && code < 0xE000;
  if (code < kSmallest[size] || code > 0x10FFFF || is_half) return {};
  return {code, size};
}

std::string Escaped(uint32_t code, bool is_byte) {
  char text[12];
  std::snprintf(text, sizeof(text), is_byte || code < 0x80 ? "\\x%02x" : "\\u%04x", code);
  return text;
}

}  // namespace

std::string Printable(std::string_view text) {
  std::string printable;
  while (!text.empty()) {
    const auto [code, num_bytes] = FirstOf(text);
    if (num_bytes == 0) {
      printable += Escaped(static_cast<unsigned char>(text[0]), /*is_byte=*/true);
    } else if (IsPrintable(code)) {
      printable += text.substr(0, num_bytes);
    } else {
      printable += Escaped(code, /*is_byte=*/false);
    }
    text.remove_prefix(std::max<size_t>(1, num_bytes));
  }
  return printable;
}

std::string PrintableLine(std::string_view text) {
  constexpr size_t kMaxBytes = 10'000;  // two paths, and more
  constexpr size_t kEndBytes = kMaxBytes / 2;
  if (text.size() <= kMaxBytes) return Printable(text);
  const auto left_out = static_cast<int64_t>(text.size() - 2 * kEndBytes);
  return Printable(text.substr(0, kEndBytes)) + " [" + WithCommas(left_out) + " bytes] " +
         Printable(text.substr(text.size() - kEndBytes));
}

std::string WithCommas(int64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-') text += ',';
    text += digits[i];
  }
  return text;
}

}  // namespace limn
