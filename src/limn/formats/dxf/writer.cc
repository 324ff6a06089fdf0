// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/writer.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "limn/util/number_text.h"

namespace limn {
namespace {

std::string RealText(double value) {
  std::string text = NumberText(value);
  if (text.find('.') != std::string::npos) return text;
  const size_t exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

// Bytes that follow the lead byte of a code point in UTF-8; 0 also if it is none.
size_t NumFollowing(unsigned char lead) {
  if (lead >= 0xF0 && lead <= 0xF4) return 3;
  if (lead >= 0xE0 && lead <= 0xEF) return 2;
  return lead >= 0xC2 && lead <= 0xDF ? 1 : 0;
}

bool Follow(const std::string& text, size_t begin, size_t count) {
  if (begin + count > text.size()) return false;
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin),
                     text.begin() + static_cast<std::ptrdiff_t>(begin + count),
                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; });
}

// The code point at a place, which is moved behind it. A byte that is not UTF-8 is one of Latin-1.
unsigned TakeCodePoint(const std::string& text, size_t* at) {
  const auto lead = static_cast<unsigned char>(text[(*at)++]);
  const size_t count = NumFollowing(lead);
  if (count == 0 || !Follow(text, *at, count)) return lead;
  unsigned code_point = lead & (0x3Fu >> count);
  for (size_t i = 0; i < count; ++i) {
    code_point = code_point << 6 | (static_cast<unsigned char>(text[(*at)++]) & 0x3Fu);
  }
  return code_point;
}

std::string EscapedUnit(unsigned unit) {
  char digits[12];
  std::snprintf(digits, sizeof(digits), "\\U+%04X", unit & 0xFFFFu);
  return digits;
}

// AutoCAD has four digits: of planes above the first they are two, as in UTF-16.
std::string Escaped(const std::string& text) {
  constexpr unsigned kFirstPrintable = 0x20, kFirstBeyondAscii = 0x7F, kBeyond = 0x10000;
  std::string escaped;
  for (size_t i = 0; i < text.size();) {
    const unsigned code_point = TakeCodePoint(text, &i);
    if (code_point < kFirstPrintable) continue;
    if (code_point < kFirstBeyondAscii) {
      escaped += static_cast<char>(code_point);
      if (code_point == '^') escaped += ' ';  // else a control code
    } else if (code_point < kBeyond) {
      escaped += EscapedUnit(code_point);
    } else {
      escaped += EscapedUnit(0xD800 + ((code_point - kBeyond) >> 10));
      escaped += EscapedUnit(0xDC00 + ((code_point - kBeyond) & 0x3FF));
    }
  }
  return escaped;
}

}  // namespace

void DxfWriter::BeginSection(const char* name) {
  Put(0, "SECTION");
  Put(2, name);
}

void DxfWriter::EndSection() { Put(0, "ENDSEC"); }

void DxfWriter::Put(int code, const std::string& text) {
  out_ << code << '\n' << Escaped(text) << '\n';
}

void DxfWriter::Put(int code, int value) { out_ << code << '\n' << value << '\n'; }

void DxfWriter::Put(int code, double value) { Put(code, RealText(value)); }

void DxfWriter::PutPoint(int x_code, const Eigen::Vector3d& point) {
  for (int axis = 0; axis < 3; ++axis) Put(x_code + 10 * axis, point[axis]);
}

void DxfWriter::PutHandle(int code, int handle) {
  char text[16];
  const auto [end, error] = std::to_chars(text, text + sizeof(text), handle, 16);
  for (char* digit = text; digit != end; ++digit) {
    if (*digit >= 'a') *digit = static_cast<char>(*digit - 'a' + 'A');
  }
  Put(code, std::string(text, end));
}

}  // namespace limn
