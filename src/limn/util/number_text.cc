// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/number_text.h"

#include <charconv>
#include <iterator>

namespace limn {

std::string NumberText(double value) {
  char text[32];
  return {text, std::to_chars(std::begin(text), std::end(text), value).ptr};
}

std::string ShortNumber(double value) {
  char text[32];
  return {
      text,
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 3).ptr};
}

std::string RoundedText(double value, int decimals) {
  char buffer[400];  // the largest number has 309 digits before the point
  std::string text(buffer, std::to_chars(std::begin(buffer), std::end(buffer), value,
                                         std::chars_format::fixed, decimals)
                               .ptr);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace limn
