// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

namespace limn {

// The help text of an option. -h shows only basic options, those that every user understands;
// --help_all shows all.
struct OptionHelp {
  OptionHelp(const char* text_, bool is_basic_ = false) : text(text_), is_basic(is_basic_) {}
  OptionHelp(std::string text_, bool is_basic_ = false)
      : text(std::move(text_)), is_basic(is_basic_) {}

  std::string text;
  bool is_basic;
};

inline OptionHelp BasicOption(std::string text) { return {std::move(text), true}; }

}  // namespace limn
