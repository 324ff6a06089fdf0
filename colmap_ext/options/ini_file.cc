// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/ini_file.h"

#include <sstream>

#include "limn/files/text_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

std::string Trimmed(const std::string& text) {
  const char* space = " \t\r";
  const size_t begin = text.find_first_not_of(space);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(space) + 1 - begin);
}

}  // namespace

std::vector<IniEntry> ReadIniFile(std::istream& in, const std::string& path) {
  std::vector<IniEntry> entries;
  std::string prefix;
  std::string raw;
  for (int number = 1; std::getline(in, raw); ++number) {
    const std::string line = Trimmed(raw);
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    const size_t equals = line.find('=');
    if (line[0] == '[' && line.back() == ']') {
      prefix = Trimmed(line.substr(1, line.size() - 2)) + ".";
    } else if (equals != std::string::npos) {
      entries.push_back(
          {prefix + Trimmed(line.substr(0, equals)), Trimmed(line.substr(equals + 1)), number});
    } else {
      throw IoError(path, "line " + std::to_string(number),
                    "neither \"key = value\" nor \"[Group]\": " + line);
    }
  }
  if (in.bad()) throw IoError(path, "read error");
  return entries;
}

std::vector<IniEntry> ReadIniFile(const std::string& path) {
  std::istringstream in(ReadTextFile(path, kMaxListBytes));
  return ReadIniFile(in, path);
}

}  // namespace limn
