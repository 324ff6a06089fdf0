// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace limn::colmap_ext {

// The name without the extension of a picture, such as ".JPG"; nothing if it has none.
std::optional<std::string> WithoutPictureExtension(const std::string& name);

}  // namespace limn::colmap_ext
