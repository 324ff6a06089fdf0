// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/text_scanner.h"

#include <cmath>

#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

}  // namespace

bool TextScanner::AtEndOfLine() {
  while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
  return at_ == text_.size() || text_[at_] == '\n';
}

bool TextScanner::AtEnd() {
  while (AtEndOfLine()) {
    if (at_ == text_.size()) return true;
    ++at_;
    ++line_;
  }
  return false;
}

std::string_view TextScanner::Word(const char* what) {
  if (AtEnd()) Fail(std::string("the file ends before ") + what);
  const size_t begin = at_;
  while (at_ < text_.size() && !IsBlank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(begin, at_ - begin);
}

double TextScanner::Number(const char* what) {
  const std::string_view word = Word(what);
  const auto value = ParseSignedNumber<double>(word);
  if (!value) {
    Fail(std::string(what) + " expected, not \"" + std::string(word.substr(0, 40)) + "\"");
  }
  return *value;
}

double TextScanner::FiniteNumber(const char* what) {
  const double value = Number(what);
  if (!std::isfinite(value)) Fail(std::string(what) + " is not finite");
  return value;
}

int TextScanner::Count(const char* what) {
  constexpr double kMaxCount = 1e9;
  const double value = Number(what);
  if (!(value >= 0 && value <= kMaxCount && value == std::floor(value))) {
    Fail(std::string(what) + " is not a count");
  }
  return static_cast<int>(value);
}

Eigen::Vector3d TextScanner::Point() {
  const double x = Number("x coordinate");
  const double y = Number("y coordinate");
  const double z = Number("z coordinate");
  const Eigen::Vector3d point(x, y, z);
  if (!point.allFinite()) Fail("coordinate not finite");
  return point;
}

std::string_view TextScanner::RestOfLine() {
  const size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  std::string_view rest = text_.substr(begin, at_ - begin);
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

void TextScanner::Fail(const std::string& reason) const {
  throw IoError(path_, "line " + std::to_string(line_), reason);
}

}  // namespace limn
