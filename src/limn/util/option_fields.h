// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

namespace limn {

// The values that an option may have: a range, or the words of an enum in the order of its values.
struct OptionValues {
  double low = 0;
  double high = 0;
  bool above_low = false;  // low itself is not allowed
  bool or_zero = false;    // 0, besides the range
  std::vector<const char*> words = {};
};

// [low, high].
OptionValues Between(double low, double high);
// (low, high].
OptionValues Above(double low, double high);
OptionValues ZeroOr(OptionValues values);
OptionValues OneOf(std::initializer_list<const char*> words);
OptionValues OnOrOff();

// Throws OptionError, which names option, value and range.
void CheckOptionValue(const char* name, double value, const OptionValues& values);

// A struct of options lists them once, for command line, ini files, provenance, keys of caches and
// checks:
//
//   struct ToyOptions {
//     double max_gap_px = 2;
//
//     template <typename Self, typename Visit>
//     static void VisitFields(Self& self, const Visit& visit) {
//       visit("max_gap_px", self.max_gap_px, Between(0, 100), "longest gap that is closed, px");
//     }
//     void Check() const { CheckFields(*this); }
//   };
//
// Self is the struct, const or not. The last argument is an OptionHelp, which states the unit. A
// field is a double, an int, a bool or an enum, whose words are given in the order of its values
// from 0. Fields that are not listed are no options: only tests set them.
template <typename Options>
void CheckFields(const Options& options) {
  Options::VisitFields(options, [](const char* name, const auto& field, const OptionValues& values,
                                   const auto& /*help*/) {
    CheckOptionValue(name, static_cast<double>(field), values);
  });
}

// The word of an enum's value.
template <typename Enum>
requires std::is_enum_v<Enum>
const char* WordOf(Enum value, const OptionValues& values) {
  return values.words.at(static_cast<size_t>(value));
}

}  // namespace limn
