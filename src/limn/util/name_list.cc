// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/name_list.h"

#include <algorithm>

#include "limn/util/number_text.h"

namespace limn {
namespace {

constexpr size_t kMaxListedNames = 5;

}  // namespace

std::string ListNames(const std::vector<std::string>& names) {
  std::string list;
  const size_t listed = std::min(names.size(), kMaxListedNames);
  for (size_t i = 0; i < listed; ++i) list += (i > 0 ? ", " : "") + names[i];
  if (listed < names.size()) list += " and " + std::to_string(names.size() - listed) + " more";
  return list;
}

std::string ListNumbers(const std::vector<NamedNumber>& items, const std::string& unit) {
  std::vector<std::string> names;
  for (const NamedNumber& item : items) {
    names.push_back(item.name + " (" + ShortNumber(item.number) + " " + unit + ")");
  }
  return ListNames(names);
}

}  // namespace limn
