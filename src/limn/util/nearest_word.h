// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limn {

// The word that was probably meant: the first of those with the fewest changes to this one
// (a character too many, missing, another one, or two exchanged), if a third of its characters or
// fewer change; else the only one that ends with it after a dot ("Group.name"). Empty: none. Time:
// the number of words times the square of their length.
std::string NearestWord(std::string_view word, const std::vector<std::string>& words);

// ": did you mean <word>?", or nothing if there is none.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& words);

}  // namespace limn
