// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/intrinsic_extrinsic.h"

#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/file_matching.h"
#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".extrinsic";

// As many rows of three numbers as the file must hold.
template <int kRows>
Eigen::Matrix<double, kRows, 3> ReadRows(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  Eigen::Matrix<double, kRows, 3> rows;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < 3; ++column) {
      rows(row, column) = scanner.FiniteNumber("element of a matrix");
    }
  }
  if (!scanner.AtEnd()) {
    scanner.Fail("more than the " + std::to_string(3 * kRows) + " numbers expected");
  }
  return rows;
}

void CheckWholeImage(const fs::path& extrinsic) {
  for (const char* extension : {".origin", ".scale"}) {
    const fs::path path = fs::path(extrinsic).replace_extension(extension);
    if (std::error_code ignored; !fs::exists(path, ignored)) continue;
    throw IoError(path.string(), "cameras of cropped or scaled images are not read");
  }
}

std::string IntrinsicPath(const fs::path& extrinsic) {
  const fs::path own = fs::path(extrinsic).replace_extension(".intrinsic");
  std::error_code ignored;
  return (fs::exists(own, ignored) ? own : extrinsic.parent_path() / "calib.intrinsic").string();
}

}  // namespace

bool HoldsIntrinsicExtrinsic(const fs::path& path) {
  return !FilesEndingWith(path, kExtension).empty();
}

ImportedScene ReadIntrinsicExtrinsic(const ImportInput& input) {
  const std::vector<fs::path> files = FilesEndingWith(input.path, kExtension);
  if (files.empty()) throw IoError(input.path.string(), "no folder with *.extrinsic");
  return ReadCameraFiles(files, input, [](const ImageSize& size, ImportedImage* image) {
    CheckWholeImage(image->path);
    const std::string intrinsic_path = IntrinsicPath(image->path);
    const Eigen::Matrix<double, 4, 3> rows = ReadRows<4>(image->path);
    image->camera =
        CameraFromCalibration(ReadRows<3>(intrinsic_path), size, {intrinsic_path, "line", 1});
    Rigid3d& pose = image->cam_from_world;
    pose.rotation = RotationFromMatrix(rows.topRows<3>(), {image->path, "line", 1});
    pose.translation = -(pose.rotation * rows.row(3).transpose().eval());
  });
}

}  // namespace limn::colmap_ext
