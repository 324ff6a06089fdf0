#pragma once

#include <string>

namespace limn::colmap_ext {

// Size and hash of a file's bytes; its name and time do not matter. Throws IoError.
std::string FileIdentity(const std::string& path);

}  // namespace limn::colmap_ext
