// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn {

// Numbers as texts, with a point as the decimal sign in every locale.

// For files: the shortest text that reads back as the same number.
std::string NumberText(double value);

// For messages: three digits, "0.125", "52.1", "1.2e+06".
std::string ShortNumber(double value);

// For pictures: rounded to this many decimals, without trailing zeros, "0.5", "100".
std::string RoundedText(double value, int decimals);

}  // namespace limn
