// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limn {

// The text for a line on a terminal: names in files may hold ends of lines, escape sequences and
// what turns the direction of writing. Control and format characters and bytes that are not UTF-8
// are escaped, as "\x1b" and "\u202e".
std::string Printable(std::string_view text);

// The same, without the middle of a text of more than 10,000 bytes.
std::string PrintableLine(std::string_view text);

// 1234567 -> "1,234,567".
std::string WithCommas(int64_t value);

}  // namespace limn
