#pragma once

#include <filesystem>
#include <string>

namespace limn::colmap_ext {

// Why a name cannot be that of an image: empty, longer than 4096 bytes, with a NUL, not UTF-8,
// absolute, or leading out of the image folder ("..") . Empty if it can.
std::string ProblemOfName(const std::string& name);

// For messages, what to try when an image is missing: "; <file> is there" if the folder has a file
// whose name differs in case, extension or the kind of slashes only. Empty if there is none.
std::string HintForMissing(const std::filesystem::path& image_dir, const std::string& name);

}  // namespace limn::colmap_ext
