#pragma once

#include <cstdint>
#include <string>

namespace limn {

// The text with a question mark for every control character (ASCII, and C1 in UTF-8), for a line
// on a terminal: names in files may hold line ends and escape sequences.
std::string Printable(std::string text);

// 1234567 -> "1,234,567".
std::string WithCommas(int64_t value);

}  // namespace limn
