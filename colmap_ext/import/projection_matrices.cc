// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/projection_matrices.h"

#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/file_matching.h"
#include "colmap_ext/model/projection_matrix.h"
#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr char kHeader[] = "CONTOUR";

std::vector<fs::path> MatrixFiles(const fs::path& folder) {
  std::vector<fs::path> files = FilesEndingWith(folder, ".projmatrix");
  return files.empty() ? FilesEndingWith(folder, ".txt") : files;
}

Eigen::Matrix<double, 3, 4> ReadMatrix(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  scanner.AtEnd();
  if (scanner.Peek() == kHeader[0]) {
    const std::string header(scanner.Word("the matrix"));
    if (header != kHeader) scanner.Fail("\"" + header + "\" found, CONTOUR or a number expected");
  }
  Eigen::Matrix<double, 3, 4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = scanner.FiniteNumber("element of a 3x4 matrix");
    }
  }
  if (!scanner.AtEnd()) scanner.Fail("more than the twelve numbers of a 3x4 matrix");
  return matrix;
}

bool IsMatrixFile(const fs::path& path) {
  try {
    ReadMatrix(path.string());
    return true;
  } catch (const IoError&) {
    return false;
  }
}

DecomposedProjection DecomposeAt(const ProjectionMatrix& projection, const FilePlace& place) {
  try {
    return Decompose(projection);
  } catch (const InputError& error) {
    place.Fail(error.what());
  }
}

}  // namespace

bool HoldsProjectionMatrices(const fs::path& path) {
  if (HoldsFile(path, {".projmatrix"})) return true;
  const std::vector<fs::path> files = MatrixFiles(path);
  return !files.empty() && (BeginsWith(files.front(), kHeader) || IsMatrixFile(files.front()));
}

ImportedScene ReadProjectionMatrices(const ImportInput& input) {
  const std::vector<fs::path> files = MatrixFiles(input.path);
  if (files.empty()) {
    throw IoError(input.path.string(), "no folder with *.projmatrix or *.txt, one per image");
  }
  return ReadCameraFiles(files, input, [](const ImageSize& size, ImportedImage* image) {
    const FilePlace place{image->path, "line", 1};
    const DecomposedProjection pose = DecomposeAt(ReadMatrix(image->path), place);
    image->camera = CameraFromCalibration(pose.intrinsics, size, place);
    image->cam_from_world = pose.cam_from_world;
  });
}

}  // namespace limn::colmap_ext
