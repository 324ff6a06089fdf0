// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/image_name.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "limn/util/lower_case.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxNameBytes = 4096;

// Number of bytes of the code point that begins with this one; 0 if none does.
size_t SequenceLength(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 0;
}

// RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF.
bool IsUtf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    const auto byte = [&](size_t k) { return static_cast<unsigned char>(text[i + k]); };
    const size_t length = SequenceLength(byte(0));
    if (length == 0 || length > text.size() - i) return false;
    for (size_t k = 1; k < length; ++k) {
      if ((byte(k) & 0xC0) != 0x80) return false;
    }
    if (length > 2) {
      const unsigned two = byte(0) << 8 | byte(1);
      const bool overlong = (two >= 0xE080 && two < 0xE0A0) || (two >= 0xF080 && two < 0xF090);
      const bool surrogate = two >= 0xEDA0 && two <= 0xEDBF;
      if (overlong || surrogate || two > 0xF48F) return false;
    }
    i += length;
  }
  return true;
}

// What is the same in names that were changed by accident.
std::string Essence(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return LowerCase(fs::path(name).stem().string());
}

}  // namespace

std::string Utf8Name(const std::string& bytes) {
  if (IsUtf8(bytes)) return bytes;
  std::string name;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      name += c;
      continue;
    }
    char escape[5];
    std::snprintf(escape, sizeof(escape), "\\x%02X", byte);
    name += escape;
  }
  return name;
}

std::string ProblemOfName(const std::string& name) {
  if (name.empty()) return "the image has no name";
  if (name.size() > kMaxNameBytes) {
    return "the image name is longer than " + std::to_string(kMaxNameBytes) + " bytes";
  }
  if (name.find('\0') != std::string::npos) return "the image name contains a NUL character";
  const fs::path path(name);
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || climbs) {
    return "image name \"" + name + "\" leads out of the image folder";
  }
  return "";
}

std::string ProblemOfNameInText(const std::string& name) {
  constexpr std::string_view kSpace = " \t\r\v\f\n";
  const bool ends_in_space = kSpace.find(name.front()) != std::string_view::npos ||
                             kSpace.find(name.back()) != std::string_view::npos;
  if (!ends_in_space && name.find('\n') == std::string::npos) return "";
  return "image name \"" + name +
         "\" has a line end, or white space at an end, which images.txt cannot hold";
}

std::string HintForMissing(const fs::path& image_dir, const std::string& name) {
  std::string with_slashes = name;
  std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
  const fs::path folder = (image_dir / with_slashes).parent_path();
  const std::string essence = Essence(name);
  std::string similar;  // the first in alphabetical order
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string candidate = it->path().string();
    if (Essence(it->path().filename().string()) != essence) continue;
    if (similar.empty() || candidate < similar) similar = candidate;
  }
  return similar.empty() ? "" : "; " + similar + " is there";
}

}  // namespace limn::colmap_ext
