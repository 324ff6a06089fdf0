// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/formats.h"

#include "colmap_ext/import/bundler.h"
#include "colmap_ext/import/intrinsic_extrinsic.h"
#include "colmap_ext/import/metashape.h"
#include "colmap_ext/import/middlebury.h"
#include "colmap_ext/import/nerf_transforms.h"
#include "colmap_ext/import/nvm.h"
#include "colmap_ext/import/openmvg.h"
#include "colmap_ext/import/opensfm.h"
#include "colmap_ext/import/projection_matrices.h"
#include "colmap_ext/import/realitycapture.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

const std::vector<ImportFormat>& ImportFormats() {
  constexpr PixelCenters kInteger = PixelCenters::kInteger;
  constexpr PixelCenters kHalf = PixelCenters::kHalf;
  static const std::vector<ImportFormat> formats = {
      {"projection_matrices", kInteger, HoldsProjectionMatrices, ReadProjectionMatrices},
      {"intrinsic_extrinsic", kInteger, HoldsIntrinsicExtrinsic, ReadIntrinsicExtrinsic},
      {kBundlerType, kHalf, HoldsBundler, ReadBundler},
      {kNvmType, kHalf, HoldsNvm, ReadNvm},
      {"middlebury", kInteger, HoldsMiddlebury, ReadMiddlebury},
      {kNerfTransformsType, kHalf, HoldsNerfTransforms, ReadNerfTransforms},
      {kOpensfmType, kHalf, HoldsOpensfm, ReadOpensfm},
      {kOpenmvgType, kInteger, HoldsOpenmvg, ReadOpenmvg},
      {kMetashapeType, kHalf, HoldsMetashape, ReadMetashape},
      {kRealityCaptureType, kHalf, HoldsRealityCapture, ReadRealityCapture},
  };
  return formats;
}

namespace {

std::string FormatNames() {
  std::string names;
  for (const ImportFormat& format : ImportFormats()) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

[[noreturn]] void FailUnrecognized(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw IoError(path.string(), "no such file or folder");
  }
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  std::vector<CameraFile> files;
  if (is_folder) {
    files = FindCameraFiles(path);
  } else if (auto file = RecognizeCameraFile(path)) {
    files = {std::move(*file)};
  }
  std::string reason = "no format of cameras recognized";
  if (!files.empty() && files[0].input_type.empty()) {
    reason = (is_folder ? files[0].path.filename().string() + " is a" : "a") + " file of " +
             files[0].program + ", which is not read: " + files[0].way_out;
  } else if (!files.empty()) {
    reason += " in this folder: give --input_path " + files[0].path.string();
  }
  throw IoError(path.string(), reason + "; --input_type may be " + FormatNames());
}

}  // namespace

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
  if (!found) FailUnrecognized(path);
  if (names != found->name) {
    throw IoError(path.string(), "several formats of cameras found (" + names +
                                     "): give the file itself or an --input_type");
  }
  return *found;
}

}  // namespace limn::colmap_ext
