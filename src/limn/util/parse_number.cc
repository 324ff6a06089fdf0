// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/parse_number.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace limn {
namespace {

// The number of digits that a text begins with.
size_t CountDigits(std::string_view text) {
  return std::min(text.find_first_not_of("0123456789"), text.size());
}

// "12", "12.", ".5", "1e-3"; no hexadecimal digits, which streams read, too.
bool IsDecimal(std::string_view text) {
  const size_t whole = CountDigits(text);
  text.remove_prefix(whole);
  size_t fraction = 0;
  if (text.starts_with('.')) {
    fraction = CountDigits(text.substr(1));
    text.remove_prefix(1 + fraction);
  }
  if (whole + fraction == 0) return false;
  if (text.empty()) return true;
  if (text.front() != 'e' && text.front() != 'E') return false;
  text.remove_prefix(1);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && CountDigits(text) == text.size();
}

}  // namespace

std::optional<double> ParseDoubleByStream(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  std::string digits(is_negative ? text.substr(1) : text);
  double value = 0;
  if (IsDecimal(digits)) {
    std::istringstream stream(digits);
    stream.imbue(std::locale::classic());
    stream >> value;
    // libc++ also fails where digits of tiny numbers are lost.
    if (stream.fail() && !(value < 1)) return std::nullopt;  // too large
    const size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
    if (value == 0 && digits.find_first_of("123456789") < exponent) return std::nullopt;
  } else {
    for (char& c : digits) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (digits == "inf" || digits == "infinity") {
      value = std::numeric_limits<double>::infinity();
    } else if (digits == "nan") {
      value = std::numeric_limits<double>::quiet_NaN();
    } else {
      return std::nullopt;
    }
  }
  return is_negative ? -value : value;
}

}  // namespace limn
