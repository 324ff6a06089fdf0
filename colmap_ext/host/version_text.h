// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn::colmap_ext {

// "limn 0.3.0 (commit 0123456789ab)", without the commit if it is unknown; a second line with the
// compiler and the libraries.
std::string VersionText();

// Version and commit, "0.3.0 0123456789ab": what belongs together has the same.
std::string BuildId();

}  // namespace limn::colmap_ext
