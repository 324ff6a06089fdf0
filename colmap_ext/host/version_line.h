#pragma once

#include <string>

namespace limn::colmap_ext {

// "limn 0.2.0 (commit 0123456789ab)"; without the commit if it is unknown.
std::string VersionLine();

}  // namespace limn::colmap_ext
