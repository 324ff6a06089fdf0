#include "colmap_ext/import/intrinsic_extrinsic.h"

#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/file_matching.h"
#include "limn/files/text_scanner.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".extrinsic";

// As many rows of three numbers as the file must hold.
template <int kRows>
Eigen::Matrix<double, kRows, 3> ReadRows(const std::string& path) {
  const std::string text = ReadWholeFile(path);
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
  const FileMatches matches = MatchFilesToImages(files, input);
  ImportedScene scene;
  scene.notes = {matches.note};
  for (size_t i = 0; i < files.size(); ++i) {
    if (matches.names[i].empty()) continue;
    ImportedImage image;
    image.path = files[i].string();
    const FilePlace place{image.path, "line", 1};
    const auto found = input.images->Find(matches.names[i], {}, place);
    if (!found) continue;
    CheckWholeImage(files[i]);
    const std::string intrinsic_path = IntrinsicPath(files[i]);
    const Eigen::Matrix<double, 4, 3> rows = ReadRows<4>(image.path);
    image.name = found->name;
    image.camera = CameraFromCalibration(ReadRows<3>(intrinsic_path), found->size,
                                         {intrinsic_path, "line", 1});
    image.cam_from_world.rotation = RotationFromMatrix(rows.topRows<3>(), place);
    image.cam_from_world.translation =
        -(image.cam_from_world.rotation * rows.row(3).transpose().eval());
    scene.images.push_back(std::move(image));
  }
  return scene;
}

}  // namespace limn::colmap_ext
