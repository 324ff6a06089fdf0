#include "colmap_ext/import/formats.h"

#include "colmap_ext/import/bundler.h"
#include "colmap_ext/import/intrinsic_extrinsic.h"
#include "colmap_ext/import/middlebury.h"
#include "colmap_ext/import/nerf_transforms.h"
#include "colmap_ext/import/nvm.h"
#include "colmap_ext/import/projection_matrices.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

const std::vector<ImportFormat>& ImportFormats() {
  constexpr PixelCenters kInteger = PixelCenters::kInteger;
  constexpr PixelCenters kHalf = PixelCenters::kHalf;
  static const std::vector<ImportFormat> formats = {
      {"projection_matrices", kInteger, HoldsProjectionMatrices, ReadProjectionMatrices},
      {"intrinsic_extrinsic", kInteger, HoldsIntrinsicExtrinsic, ReadIntrinsicExtrinsic},
      {"bundler", kHalf, HoldsBundler, ReadBundler},
      {"nvm", kHalf, HoldsNvm, ReadNvm},
      {"middlebury", kInteger, HoldsMiddlebury, ReadMiddlebury},
      {"nerf_transforms", kHalf, HoldsNerfTransforms, ReadNerfTransforms},
  };
  return formats;
}

const ImportFormat* FindImportFormat(const std::string& name) {
  for (const ImportFormat& format : ImportFormats()) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

const ImportFormat& RecognizeFormat(const std::filesystem::path& path) {
  const ImportFormat* found = nullptr;
  std::string names;
  for (const ImportFormat& format : ImportFormats()) {
    if (!format.recognize(path)) continue;
    names += (found ? ", " : "") + std::string(format.name);
    if (!found) found = &format;
  }
  if (!found) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(path, ignored);
    throw IoError(path.string(), exists ? "no format of cameras recognized; give an --input_type"
                                        : "no such file or folder");
  }
  if (names != found->name) {
    throw IoError(path.string(), "several formats of cameras found (" + names +
                                     "): give the file itself or an --input_type");
  }
  return *found;
}

}  // namespace limn::colmap_ext
