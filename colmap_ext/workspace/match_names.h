// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace limn::colmap_ext {

// A name that may be that of either of two files.
struct AmbiguousName {
  int name = 0;
  int file = 0;
  int other_file = 0;
};

struct NameMatches {
  std::vector<int> file_of;  // per name the place of its file in the list; -1: none
  std::vector<AmbiguousName> ambiguous;
  // How names were matched, one line per way, for the user: "24 names are in gb18030, those of the
  // files in UTF-8 (<name> is <file>)".
  std::vector<std::string> ways;
};

// Matches names with files, relative paths both, that are the same text in other bytes: composed or
// not, with back slashes, or in another encoding. The encodings under which most of the names that
// are left have a file come first, and so on. A file belongs to one name only; a name that fits
// several files in equally good ways is ambiguous, and has none. Time: about a hundred conversions
// per name and file that is not ASCII.
NameMatches MatchNames(const std::vector<std::string>& names,
                       const std::vector<std::string>& files);

}  // namespace limn::colmap_ext
