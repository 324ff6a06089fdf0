#pragma once

#include <filesystem>
#include <string>

namespace limn::colmap_ext {

// Why a name is not valid for an image: empty, longer than 4096 bytes, with a NUL, not UTF-8,
// absolute, or leading out of the image folder (".."). Empty if it is valid.
std::string ProblemOfName(const std::string& name);

// Why a valid name cannot be read back from `images.txt`, where it ends a line: line ends, or white
// space at either end. Empty if it can.
std::string ProblemOfNameInText(const std::string& name);

// A hint for messages about a missing image: "; <file> is there" if the folder has a file whose
// name differs only in case, extension or slashes. Empty if there is none.
std::string HintForMissing(const std::filesystem::path& image_dir, const std::string& name);

}  // namespace limn::colmap_ext
