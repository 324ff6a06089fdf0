// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>

namespace limn {

// Converts to a field of any type, for counting fields.
struct AnyField {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor)
};

// Number of fields of an aggregate: the most initializers that it accepts.
template <class T, class... Fields>
constexpr size_t NumFields() {
  if constexpr (requires { T{Fields{}..., AnyField{}}; }) {
    return NumFields<T, Fields..., AnyField>();
  } else {
    return sizeof...(Fields);
  }
}

// Calls visit(field) for every field of a plain struct, const or not, in order of declaration.
template <class Struct, class Visit>
void ForEachField(Struct& value, const Visit& visit) {
  constexpr size_t kCount = NumFields<std::remove_const_t<Struct>>();
  static_assert(kCount >= 1 && kCount <= 8, "give ForEachField a case for this number of fields");
  const auto visit_all = [&](auto&... fields) { (visit(fields), ...); };
  if constexpr (kCount == 1) {
    auto& [a] = value;
    visit_all(a);
  } else if constexpr (kCount == 2) {
    auto& [a, b] = value;
    visit_all(a, b);
  } else if constexpr (kCount == 3) {
    auto& [a, b, c] = value;
    visit_all(a, b, c);
  } else if constexpr (kCount == 4) {
    auto& [a, b, c, d] = value;
    visit_all(a, b, c, d);
  } else if constexpr (kCount == 5) {
    auto& [a, b, c, d, e] = value;
    visit_all(a, b, c, d, e);
  } else if constexpr (kCount == 6) {
    auto& [a, b, c, d, e, f] = value;
    visit_all(a, b, c, d, e, f);
  } else if constexpr (kCount == 7) {
    auto& [a, b, c, d, e, f, g] = value;
    visit_all(a, b, c, d, e, f, g);
  } else if constexpr (kCount == 8) {
    auto& [a, b, c, d, e, f, g, h] = value;
    visit_all(a, b, c, d, e, f, g, h);
  }
}

}  // namespace limn
