// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/picture_names.h"

#include <string_view>

#include "limn/util/lower_case.h"

namespace limn::colmap_ext {
namespace {

constexpr std::string_view kPictureExtensions[] = {".png",  ".jpg", ".jpeg", ".tif",
                                                   ".tiff", ".bmp", ".webp", ".jp2",
                                                   ".pgm",  ".ppm", ".pbm",  ".pnm"};

}  // namespace

std::optional<std::string> WithoutPictureExtension(const std::string& name) {
  const std::string lower = LowerCase(name);
  for (const std::string_view extension : kPictureExtensions) {
    if (lower.ends_with(extension) && lower.size() > extension.size()) {
      return name.substr(0, name.size() - extension.size());
    }
  }
  return std::nullopt;
}

}  // namespace limn::colmap_ext
