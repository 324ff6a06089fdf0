// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/import_input.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The run of digits at `at` without leading zeros; moves `at` behind it.
std::string TakeNumber(const std::string& text, size_t* at) {
  const size_t begin = *at;
  while (*at < text.size() && IsDigit(text[*at])) ++*at;
  const std::string digits = text.substr(begin, *at - begin);
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

std::vector<fs::path> FilesEndingWithAny(const fs::path& folder,
                                         const std::vector<std::string>& ends) {
  std::vector<fs::path> files;
  for (const std::string& end : ends) {
    const std::vector<fs::path> more = FilesEndingWith(folder, end);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

std::string AnyOf(const std::vector<std::string>& ends) {
  std::string text;
  for (const std::string& end : ends) text += (text.empty() ? "*" : " or *") + end;
  return text;
}

// Leaves off the two numbers that Bundler may write after a name. No white space at either end.
std::string_view NameOfLine(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r\v\f";
  std::string_view name = line;
  for (const std::string_view characters : {"+-.0123456789Ee", "0123456789"}) {
    const size_t word = name.find_last_of(kSpace) + 1;
    if (word == 0 || name.find_first_not_of(characters, word) != name.npos) return line;
    name = name.substr(0, name.find_last_not_of(kSpace, word - 1) + 1);
  }
  return name;
}

}  // namespace

bool NaturallyLess(const std::string& a, const std::string& b) {
  size_t i = 0;
  size_t k = 0;
  while (i < a.size() && k < b.size()) {
    if (IsDigit(a[i]) && IsDigit(b[k])) {
      const std::string number_a = TakeNumber(a, &i);
      const std::string number_b = TakeNumber(b, &k);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
    } else if (a[i] != b[k]) {
      return a[i] < b[k];
    } else {
      ++i;
      ++k;
    }
  }
  // Equal except for leading zeros, or one is the beginning of the other.
  return a.size() - i != b.size() - k ? a.size() - i < b.size() - k : a < b;
}

std::vector<fs::path> FilesEndingWith(const fs::path& folder, const std::string& end) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.ends_with(end)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return NaturallyLess(a.filename().string(), b.filename().string());
  });
  return files;
}

fs::path TheFile(const fs::path& path, const std::vector<std::string>& ends) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path;
  if (!fs::exists(path, ignored)) throw IoError(path.string(), "no such file or folder");
  const std::vector<fs::path> files = FilesEndingWithAny(path, ends);
  if (files.empty()) throw IoError(path.string(), "no file " + AnyOf(ends) + " in this folder");
  if (files.size() > 1) {
    throw IoError(path.string(), "several files " + AnyOf(ends) + " in this folder (" +
                                     files[0].filename().string() + ", " +
                                     files[1].filename().string() + "): give the path of one");
  }
  return files.front();
}

fs::path TheCameraFile(const fs::path& path, const std::string& input_type) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path;
  if (!fs::exists(path, ignored)) throw IoError(path.string(), "no such file or folder");
  std::vector<fs::path> files = FilesEndingWith(path, "");
  std::erase_if(files, [&](const fs::path& file) {
    const auto found = RecognizeCameraFile(file);
    return !found || found->input_type != input_type;
  });
  if (files.empty()) throw IoError(path.string(), "no " + input_type + " file in this folder");
  if (files.size() > 1) {
    throw IoError(path.string(), "several " + input_type + " files in this folder (" +
                                     files[0].filename().string() + ", " +
                                     files[1].filename().string() + "): give the path of one");
  }
  return files.front();
}

bool HoldsFile(const fs::path& path, const std::vector<std::string>& ends) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return !FilesEndingWithAny(path, ends).empty();
  const std::string name = path.filename().string();
  return fs::is_regular_file(path, ignored) &&
         std::any_of(ends.begin(), ends.end(),
                     [&](const std::string& end) { return name.ends_with(end); });
}

bool BeginsWith(const fs::path& file, const std::string& text) {
  std::ifstream in(file, std::ios::binary);
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string mark(kMark.size(), '\0');
  in.read(mark.data(), static_cast<std::streamsize>(mark.size()));
  if (!in || mark != kMark) {
    in.clear();
    in.seekg(0);
  }
  in >> std::ws;
  std::string start(text.size(), '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return in && start == text;
}

std::vector<std::string> ReadImageList(const std::string& path) {
  std::ifstream in = OpenFile(path);
  std::vector<std::string> names;
  LineReader reader(in, path);
  while (reader.NextLine()) {
    Fields fields(reader);
    if (!fields.AtEnd()) names.emplace_back(NameOfLine(fields.Rest()));
  }
  return names;
}

}  // namespace limn::colmap_ext
