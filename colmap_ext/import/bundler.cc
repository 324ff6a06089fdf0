// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/bundler.h"

#include "colmap_ext/import/calibration.h"
#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kEnds = {".out"};
constexpr char kHeader[] = "# Bundle file";
constexpr char kVersion[] = "# Bundle file v0.3";

std::string ListPath(const ImportInput& input, const fs::path& file) {
  if (!input.list_path.empty()) return input.list_path;
  const std::string name = file.filename().string();
  const fs::path folder = file.parent_path();
  std::vector<fs::path> candidates = {folder / (name + ".list.txt")};
  constexpr std::string_view kColmapEnd = ".bundle.out";
  if (name.ends_with(kColmapEnd)) {
    candidates.push_back(folder / (name.substr(0, name.size() - kColmapEnd.size()) + ".list.txt"));
  }
  candidates.push_back(folder / "list.txt");
  candidates.push_back(fs::absolute(file).lexically_normal().parent_path().parent_path() /
                       "list.txt");
  std::error_code ignored;
  for (const fs::path& path : candidates) {
    if (fs::is_regular_file(path, ignored)) return path.string();
  }
  throw IoError(file.string(), "the list of its images is not beside it (" +
                                   candidates.front().filename().string() +
                                   " or list.txt): give a --list_path");
}

struct BundlerCamera {
  double focal = 0;
  double k1 = 0;
  double k2 = 0;
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  int line = 0;
};

BundlerCamera ReadCamera(TextScanner* scanner) {
  BundlerCamera camera;
  camera.focal = scanner->FiniteNumber("focal length");
  camera.line = scanner->line();
  camera.k1 = scanner->FiniteNumber("k1");
  camera.k2 = scanner->FiniteNumber("k2");
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      camera.rotation(row, column) = scanner->FiniteNumber("element of a rotation");
    }
  }
  for (double& t : camera.translation) t = scanner->FiniteNumber("element of a translation");
  return camera;
}

Camera ToCamera(const BundlerCamera& bundler, const ImageSize& size) {
  Camera camera;
  camera.width = static_cast<uint64_t>(size.width);
  camera.height = static_cast<uint64_t>(size.height);
  camera.params = {bundler.focal, 0.5 * size.width, 0.5 * size.height};
  camera.model = CameraModelId::kSimplePinhole;
  if (bundler.k1 != 0 || bundler.k2 != 0) {
    camera.model = CameraModelId::kRadial;
    camera.params.insert(camera.params.end(), {bundler.k1, bundler.k2});
  }
  return camera;
}

// From y up and z backwards to y down and z forward.
const Eigen::DiagonalMatrix<double, 3> kTurn(1, -1, -1);

ImageOfCamera ReadCameras(const std::vector<std::string>& names, const fs::path& list_folder,
                          const std::string& path, const ImportInput& input, TextScanner* scanner,
                          ImportedScene* scene) {
  ImageOfCamera image_of_camera(names.size(), -1);
  int num_without_pose = 0;
  for (size_t i = 0; i < names.size(); ++i) {
    const BundlerCamera camera = ReadCamera(scanner);
    if (camera.focal == 0) {
      ++num_without_pose;
      continue;
    }
    ImportedImage image;
    image.path = path;
    image.number = static_cast<uint64_t>(camera.line);
    const FilePlace place{image.path, "line", image.number};
    const auto found = input.images->Find(names[i], list_folder, place);
    if (!found) continue;
    image.name = found->name;
    image.camera = ToCamera(camera, found->size);
    image.cam_from_world.rotation = RotationFromMatrix(kTurn * camera.rotation, place);
    image.cam_from_world.translation = kTurn * camera.translation;
    image_of_camera[i] = static_cast<int>(scene->images.size());
    scene->images.push_back(std::move(image));
  }
  if (num_without_pose > 0) {
    scene->notes.push_back(std::to_string(num_without_pose) + " of " +
                           std::to_string(names.size()) +
                           " images were not reconstructed and are left out");
  }
  return image_of_camera;
}

}  // namespace

bool HoldsBundler(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return BeginsWith(path, kHeader);
  const std::vector<fs::path> files = FilesEndingWith(path, kEnds.front());
  return !files.empty() && BeginsWith(files.front(), kHeader);
}

ImportedScene ReadBundler(const ImportInput& input) {
  const fs::path file = TheFile(input.path, kEnds);
  const std::string path = file.string();
  const std::string list_path = ListPath(input, file);
  const std::vector<std::string> names = ReadImageList(list_path);
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  if (scanner.RestOfLine() != kVersion) {
    scanner.Fail(std::string("\"") + kVersion + "\" expected");
  }
  const int num_cameras = scanner.Count("number of cameras");
  const int num_points = scanner.Count("number of points");
  if (static_cast<size_t>(num_cameras) != names.size()) {
    scanner.Fail(std::to_string(num_cameras) + " cameras, but " + list_path + " lists " +
                 std::to_string(names.size()) + " images");
  }
  ImportedScene scene;
  scene.notes = {"Read " + path + " with " + list_path};
  const ImageOfCamera image_of_camera =
      ReadCameras(names, fs::path(list_path).parent_path(), path, input, &scanner, &scene);
  SetPoints(ReadTrackedPoints(num_points, image_of_camera, &scanner), &scene);
  if (!scanner.AtEnd()) {
    scanner.Fail("more than the " + std::to_string(num_points) + " points that were announced");
  }
  for (ImportedImage& image : scene.images) {
    const Eigen::Vector2d center(image.camera.params[1], image.camera.params[2]);
    for (Observation& observation : image.observations) {
      observation.position.y() *= -1;
      observation.position += center;
    }
  }
  return scene;
}

}  // namespace limn::colmap_ext
