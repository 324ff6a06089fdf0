#include "colmap_ext/model/line_reader.h"

#include <algorithm>

namespace limn::colmap_ext {
namespace {

constexpr std::string_view kSpace = " \t\r\v\f";

void SkipSpace(std::string_view* text) {
  text->remove_prefix(std::min(text->find_first_not_of(kSpace), text->size()));
}

}  // namespace

bool LineReader::NextLine() {
  if (!std::getline(in_, line_)) return false;
  ++number_;
  if (line_.ends_with('\r')) line_.pop_back();
  return true;
}

bool LineReader::NextRecord() {
  while (NextLine()) {
    const size_t first = line_.find_first_not_of(kSpace);
    if (first != std::string::npos && line_[first] != '#') return true;
  }
  return false;
}

bool Fields::AtEnd() {
  SkipSpace(&rest_);
  return rest_.empty();
}

std::string_view Fields::Next(const char* what) {
  if (AtEnd()) place_.Fail(std::string("the line ends before ") + what);
  const std::string_view field = rest_.substr(0, rest_.find_first_of(kSpace));
  rest_.remove_prefix(field.size());
  return field;
}

std::string_view Fields::Rest() {
  SkipSpace(&rest_);
  return rest_.substr(0, rest_.find_last_not_of(kSpace) + 1);
}

void Fields::FailNumber(std::string_view field, const char* what) const {
  std::string reason = "\"";
  reason.append(field).append("\" is not a number (").append(what).append(")");
  place_.Fail(reason);
}

}  // namespace limn::colmap_ext
