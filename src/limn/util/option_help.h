#pragma once

#include <string>
#include <utility>

namespace limn {

// What a help text says of an option. Basic options are those that every user understands: help
// shows them first, the others only when all are asked for.
struct OptionHelp {
  OptionHelp(const char* text_, bool is_basic_ = false) : text(text_), is_basic(is_basic_) {}
  OptionHelp(std::string text_, bool is_basic_ = false)
      : text(std::move(text_)), is_basic(is_basic_) {}

  std::string text;
  bool is_basic;
};

inline OptionHelp BasicOption(std::string text) { return {std::move(text), true}; }

}  // namespace limn
