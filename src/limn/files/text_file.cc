// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/text_file.h"

#include "limn/util/errors.h"

namespace limn {
namespace {

// Null if it is neither. A text begins with a character of ASCII: without a mark, the zeros beside
// it tell.
const char* WideEncoding(std::string_view start) {
  using namespace std::string_view_literals;
  const auto begins = [&](std::string_view mark) { return start.starts_with(mark); };
  const auto is_zero = [&](size_t at) { return at < start.size() && start[at] == '\0'; };
  if (begins("\xFF\xFE\0\0"sv) || begins("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (begins("\xFF\xFE"sv) || begins("\xFE\xFF"sv)) return "UTF-16";
  if (start.size() < 4) return nullptr;
  if (is_zero(0) != is_zero(1) && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3)) {
    return "UTF-16";
  }
  return nullptr;
}

}  // namespace

size_t MarkLength(const std::string& path, std::string_view start) {
  if (const char* encoding = WideEncoding(start)) {
    throw IoError(path, std::string("is text in ") + encoding +
                            ", as Notepad's \"Unicode\" and PowerShell's \">\" write it: save it "
                            "as UTF-8");
  }
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return start.starts_with(kMark) ? kMark.size() : 0;
}

std::string ReadTextFile(const std::string& path, uint64_t max_bytes) {
  std::string text = ReadWholeFile(path, max_bytes);
  text.erase(0, MarkLength(path, text));
  return text;
}

}  // namespace limn
