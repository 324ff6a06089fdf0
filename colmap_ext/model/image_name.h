// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace limn::colmap_ext {

// The name by which users know an image: that of its bytes if these are UTF-8; else, as a code page
// does not tell its name, all bytes that are not ASCII are written as `\xHH`.
std::string Utf8Name(const std::string& bytes);

// Why a name is not valid for an image: empty, longer than 4096 bytes, with a NUL, absolute, or
// leading out of the image folder (".."). Empty if it is valid. It need not be UTF-8.
std::string ProblemOfName(const std::string& name);

// Why a valid name cannot be read back from `images.txt`, where it ends a line: line ends, or white
// space at either end. Empty if it can.
std::string ProblemOfNameInText(const std::string& name);

// A hint for messages about a missing image: "; <file> is there" if the folder has a file whose
// name differs only in case, extension or slashes. Empty if there is none.
std::string HintForMissing(const std::filesystem::path& image_dir, const std::string& name);

}  // namespace limn::colmap_ext
