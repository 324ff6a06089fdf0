#include "limn/formats/dxf/writer.h"

#include <charconv>
#include <cstdio>
#include <vector>

#include "limn/util/number_text.h"

namespace limn {
namespace {

std::string RealText(double value) {
  std::string text = NumberText(value);
  if (text.find('.') != std::string::npos) return text;
  const size_t exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

// Of the lead byte of a code point in UTF-8: its own bits, and the bytes that follow.
struct LeadByte {
  unsigned bits = 0;
  int more = 0;
};

LeadByte LeadOf(unsigned char byte) {
  if (byte >= 0xF0) return {byte & 0x07u, 3};
  if (byte >= 0xE0) return {byte & 0x0Fu, 2};
  if (byte >= 0xC0) return {byte & 0x1Fu, 1};
  return {byte, 0};
}

// AutoCAD has four digits: of planes above the first it shows two code points.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (size_t i = 0; i < text.size();) {
    auto [code_point, more] = LeadOf(static_cast<unsigned char>(text[i++]));
    for (; more > 0 && i < text.size(); --more) {
      code_point = code_point << 6 | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
    }
    if (code_point < 0x80) {
      escaped += static_cast<char>(code_point);
      continue;
    }
    constexpr unsigned kBeyond = 0x10000;
    const bool is_beyond = code_point >= kBeyond;
    const unsigned rest = code_point - kBeyond;
    for (const unsigned part :
         is_beyond ? std::vector<unsigned>{0xD800 + (rest >> 10), 0xDC00 + (rest & 0x3FF)}
                   : std::vector<unsigned>{code_point}) {
      char digits[8];
      std::snprintf(digits, sizeof(digits), "%04X", part);
      escaped += std::string("\\U+") + digits;
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
