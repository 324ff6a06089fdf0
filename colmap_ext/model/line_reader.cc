// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/line_reader.h"

#include <algorithm>

#include "limn/files/text_file.h"

namespace limn::colmap_ext {
namespace {

constexpr std::string_view kSpace = " \t\r\v\f";

void SkipSpace(std::string_view* text) {
  text->remove_prefix(std::min(text->find_first_not_of(kSpace), text->size()));
}

// An image may have millions of points in one line.
constexpr size_t kMaxLineBytes = 1 << 28;

}  // namespace

// std::getline would take a whole file of another format for one line.
bool LineReader::NextLine() {
  line_.clear();
  char part[1 << 12];
  do {
    in_.clear(in_.rdstate() & ~std::ios::failbit);  // of a part that was full
    in_.getline(part, sizeof(part));
    const std::streamsize end_of_line = in_.good() ? 1 : 0;
    line_.append(part, static_cast<size_t>(in_.gcount() - end_of_line));
    if (line_.size() > kMaxLineBytes) {
      FilePlace{path_, "line", number_ + 1}.Fail("is longer than 256 MB");
    }
  } while (in_.fail() && !in_.eof() && !in_.bad());
  if (in_.fail() && line_.empty()) return false;
  if (number_++ == 0) line_.erase(0, MarkLength(path_, line_));
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
