// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace limn {

// The number that is all of a text, with a point as the decimal sign in every locale; nothing for
// other texts.
template <typename Number>
std::optional<Number> WholeNumber(const std::string& text) {
  Number number{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || end != last) return std::nullopt;
  return number;
}

}  // namespace limn
