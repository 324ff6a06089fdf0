// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/middlebury.h"

#include "colmap_ext/import/calibration.h"
#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"

namespace limn::colmap_ext {
namespace {

const std::vector<std::string> kEnds = {"_par.txt"};

Eigen::Matrix3d ReadMatrix(const char* what, TextScanner* scanner) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix(row, column) = scanner->FiniteNumber(what);
  }
  return matrix;
}

}  // namespace

bool HoldsMiddlebury(const std::filesystem::path& path) { return HoldsFile(path, kEnds); }

ImportedScene ReadMiddlebury(const ImportInput& input) {
  const std::string path = TheFile(input.path, kEnds).string();
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  const int count = scanner.Count("number of images");
  ImportedScene scene;
  scene.notes = {"Read " + path};
  for (int i = 0; i < count; ++i) {
    ImportedImage image;
    const std::string name(scanner.Word("the line of every image"));
    image.path = path;
    image.number = static_cast<uint64_t>(scanner.line());
    const FilePlace place{image.path, "line", image.number};
    const Eigen::Matrix3d calibration = ReadMatrix("element of K", &scanner);
    const Eigen::Matrix3d rotation = ReadMatrix("element of R", &scanner);
    for (double& t : image.cam_from_world.translation) t = scanner.FiniteNumber("element of t");
    if (!scanner.AtEndOfLine()) scanner.Fail("more than a name and 21 numbers");
    const auto found = input.images->Find(name, std::filesystem::path(path).parent_path(), place);
    if (!found) continue;
    image.name = found->name;
    image.camera = CameraFromCalibration(calibration, found->size, place);
    image.cam_from_world.rotation = RotationFromMatrix(rotation, place);
    scene.images.push_back(std::move(image));
  }
  if (!scanner.AtEnd()) scanner.Fail("more lines than the " + std::to_string(count) + " images");
  return scene;
}

}  // namespace limn::colmap_ext
