// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace limn {

// A `key = value` line under a [Group] header, as in COLMAP's project.ini; the key becomes
// "Group.key".
struct IniEntry {
  std::string key;
  std::string value;
  int line = 0;
};

// Blank lines and lines that begin with '#' or ';' are skipped; a value may contain these
// characters. Throws IoError with path and line.
std::vector<IniEntry> ReadIniFile(std::istream& in, const std::string& path);
std::vector<IniEntry> ReadIniFile(const std::string& path);

}  // namespace limn
