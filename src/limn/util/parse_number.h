// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace limn {

// As ParseNumber<double>, for standard libraries that read no floating numbers, such as libc++ 19.
std::optional<double> ParseDoubleByStream(std::string_view text);

// The number that is all of a text, as std::from_chars reads it: with a point as the decimal sign
// in every locale, without blanks or a plus. Nothing for other texts and for numbers that the type
// cannot hold.
template <typename Number>
std::optional<Number> ParseNumber(std::string_view text) {
#ifdef __cpp_lib_to_chars
  constexpr bool kByStream = false;
#else
  constexpr bool kByStream = std::is_same_v<Number, double>;
#endif
  if constexpr (kByStream) {
    return ParseDoubleByStream(text);
  } else {
    Number number{};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last) return std::nullopt;
    return number;
  }
}

// The same with a plus that some programs write.
template <typename Number>
std::optional<Number> ParseSignedNumber(std::string_view text) {
  if (text.starts_with("+-")) return std::nullopt;
  return ParseNumber<Number>(text.starts_with('+') ? text.substr(1) : text);
}

}  // namespace limn
