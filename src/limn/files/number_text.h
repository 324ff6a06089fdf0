#pragma once

#include <charconv>
#include <string>

namespace limn {

// The shortest text that reads back as the same number.
inline std::string NumberText(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof(text), value);
  return {text, end};
}

}  // namespace limn
