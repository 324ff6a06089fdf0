// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace limn {

// The names of the values of an enum, which count from 0.
template <typename Enum, size_t kCount>
struct NameTable {
  std::array<const char*, kCount> names;

  const char* Of(Enum value) const { return names[static_cast<size_t>(value)]; }

  std::optional<Enum> Find(std::string_view name) const {
    for (size_t i = 0; i < kCount; ++i) {
      if (name == names[i]) return static_cast<Enum>(i);
    }
    return std::nullopt;
  }
};

}  // namespace limn
