// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn::colmap_ext {

// A way to read the bytes of a name as text.
struct NameEncoding {
  // For users: "UTF-8", "windows-936", "UTF-8 read as windows-1252".
  std::string text;
  // ICU's name of the code page; empty: UTF-8.
  std::string code_page;
  // What the bytes were taken for when they were converted to UTF-8, as unzip and FTP programs do;
  // empty: they were not.
  std::string mistaken_for;
};

// UTF-8 first, then the code pages that Windows, DOS and old Unix systems have used for names of
// files, then what becomes of such names when they are unpacked on a system of another code page.
const std::vector<NameEncoding>& NameEncodings();

// The name as UTF-8 in composed form (NFC), in which names are equal that look equal, with '/'
// between folders. Nothing if the bytes are no text in this encoding.
std::optional<std::string> TextOfName(std::string_view bytes, const NameEncoding& encoding);

}  // namespace limn::colmap_ext
