#include "limn/formats/dxf/writer.h"

#include <charconv>

#include "limn/util/number_text.h"

namespace limn {
namespace {

std::string RealText(double value) {
  std::string text = NumberText(value);
  if (text.find('.') != std::string::npos) return text;
  const size_t exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

}  // namespace

void DxfWriter::BeginSection(const char* name) {
  Put(0, "SECTION");
  Put(2, name);
}

void DxfWriter::EndSection() { Put(0, "ENDSEC"); }

void DxfWriter::Put(int code, const std::string& text) { out_ << code << '\n' << text << '\n'; }

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
