// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn::colmap_ext {

// The lines of a text file, with their numbers, without byte order mark. Throws IoError for text in
// UTF-16 or UTF-32.
class LineReader {
 public:
  LineReader(std::istream& in, std::string path) : in_(in), path_(std::move(path)) {}

  // The next line, without CR or LF. False at the end of the file.
  bool NextLine();
  // The next line that is neither blank nor a comment.
  bool NextRecord();

  const std::string& line() const { return line_; }
  FilePlace Here() const { return {path_, "line", number_}; }

 private:
  std::istream& in_;
  std::string path_;
  std::string line_;
  uint64_t number_ = 0;
};

// The fields of one line, separated by white space; numbers use '.' in any locale. Every failure is
// an IoError with the line.
class Fields {
 public:
  explicit Fields(const LineReader& reader) : rest_(reader.line()), place_(reader.Here()) {}

  bool AtEnd();
  // The next field; fails if there is none.
  std::string_view Next(const char* what);
  // The rest of the line, without white space at either end.
  std::string_view Rest();
  const FilePlace& place() const { return place_; }

  template <typename T>
  T Number(const char* what) {
    const std::string_view field = Next(what);
    const auto number = ParseSignedNumber<T>(field);
    if (!number) FailNumber(field, what);
    return *number;
  }

 private:
  [[noreturn]] void FailNumber(std::string_view field, const char* what) const;

  std::string_view rest_;
  FilePlace place_;
};

}  // namespace limn::colmap_ext
