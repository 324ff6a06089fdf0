#pragma once

#include <string>

namespace limn::colmap_ext {

// "limn 0.3.0 (commit 0123456789ab)", without the commit if it is unknown; a second line with the
// compiler and the libraries.
std::string VersionText();

}  // namespace limn::colmap_ext
