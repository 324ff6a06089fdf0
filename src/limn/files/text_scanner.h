// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

namespace limn {

// Scans the words and numbers of a text. Errors are IoError with path and line.
class TextScanner {
 public:
  // The text must outlive the scanner. `first_line` is the number of the text's first line.
  TextScanner(std::string path, std::string_view text, int first_line = 1)
      : path_(std::move(path)), text_(text), line_(first_line) {}

  // Skips white space, line ends included; returns whether nothing is left.
  bool AtEnd();
  // Skips blanks but not line ends; returns whether nothing is left on the line.
  bool AtEndOfLine();
  // The next character, 0 at the end.
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  // The next word; throws at the end of the text.
  std::string_view Word(const char* what);
  // The next number; `what` names it in errors.
  double Number(const char* what);
  // The next number, which must be finite.
  double FiniteNumber(const char* what);
  // The next number, which must be an integer from 0 to 10^9.
  int Count(const char* what);
  Eigen::Vector3d Point();
  // The rest of the line, without its end.
  std::string_view RestOfLine();
  // Current line number, from 1.
  int line() const { return line_; }

  [[noreturn]] void Fail(const std::string& reason) const;

 private:
  std::string path_;
  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
};

}  // namespace limn
