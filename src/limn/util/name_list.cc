#include "limn/util/name_list.h"

#include <algorithm>
#include <cstdio>

namespace limn {
namespace {

constexpr size_t kMaxListedNames = 5;

}  // namespace

std::string ShortNumber(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

std::string ListNumbers(const std::vector<NamedNumber>& items, const std::string& unit) {
  std::string list;
  const size_t listed = std::min(items.size(), kMaxListedNames);
  for (size_t i = 0; i < listed; ++i) {
    if (i > 0) list += ", ";
    list += items[i].name + " (" + ShortNumber(items[i].number) + " " + unit + ")";
  }
  if (listed < items.size()) list += " and " + std::to_string(items.size() - listed) + " more";
  return list;
}

}  // namespace limn
