// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace limn::colmap_ext {

// Size and hash of a file's bytes; its name and time do not matter. Throws IoError.
std::string FileIdentity(const std::string& path);
// That of a file with these bytes.
std::string IdentityOfBytes(std::string_view bytes);

}  // namespace limn::colmap_ext
