// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/mask_list.h"

#include <system_error>

#include "colmap_ext/workspace/find_masks.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

std::string RelativePath(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path relative = fs::relative(file, folder, error);
  return error || relative.empty() ? fs::absolute(file).string() : relative.string();
}

}  // namespace

void WriteMaskList(const ImageMasks& masks, const fs::path& model_dir, const OutputPath& folder) {
  constexpr const char* kSeparators = "\t\n\r";
  for (const auto& [image, mask] : masks) {
    if ((image + mask).find_first_of(kSeparators) != std::string::npos) {
      throw IoError(mask, "the name of this mask or of its image has a tab or a line end, which " +
                              std::string(kMaskList) + " cannot hold: rename it");
    }
  }
  WriteFileAtomically(folder / kMaskList, [&](std::ostream& out) {
    out << "# IMAGE_NAME<tab>MASK, relative to this folder; 0 = do not use\n";
    for (const auto& [image, mask] : masks) {
      out << image << '\t' << RelativePath(mask, model_dir) << '\n';
    }
  });
}

}  // namespace limn::colmap_ext
