// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "limn/files/json_value.h"

namespace limn {

// Of the views of a drawing.json.
using JsonViewIds = std::map<std::string, int>;

// The views that a list names. Throws InputError if one is unknown.
inline std::vector<int> ViewsOf(const JsonValue& names, const JsonViewIds& ids) {
  std::vector<int> views;
  for (const JsonValue& name : names.Items()) {
    const auto id = ids.find(name.Text());
    if (id == ids.end()) name.Fail("is not in the list of views");
    views.push_back(id->second);
  }
  return views;
}

}  // namespace limn
