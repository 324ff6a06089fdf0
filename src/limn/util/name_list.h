// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace limn {

struct NamedNumber {
  std::string name;
  double number = 0;
};

// For messages: "b.jpg, a.jpg and 7 more", in the given order, at most five.
std::string ListNames(const std::vector<std::string>& names);

// The same with numbers: "b.jpg (52.1 px), a.jpg (3 px) and 7 more".
std::string ListNumbers(const std::vector<NamedNumber>& items, const std::string& unit);

}  // namespace limn
