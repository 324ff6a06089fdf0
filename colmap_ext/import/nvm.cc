// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/nvm.h"

#include <algorithm>
#include <cmath>

#include "colmap_ext/import/measurement_distortion.h"
#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNvmEnds = {".nvm"};
constexpr char kNvmHeader[] = "NVM_V3";
constexpr double kMaxDistortionErrorPx = 1e-3;

struct NvmCamera {
  std::string name;
  double focal = 0;
  std::array<double, 4> quaternion = {};
  Eigen::Vector3d center;
  double distortion = 0;
  int line = 0;
};

// Cameras of a model and where its points are in the file.
struct NvmModel {
  std::vector<NvmCamera> cameras;
  int num_points = 0;
  TextScanner points;
};

// Splits "name f qw qx qy qz cx cy cz r 0" before the last ten words: names may hold blanks.
NvmCamera ReadCamera(const std::string& path, TextScanner* scanner) {
  constexpr std::string_view kBlanks = " \t";
  if (scanner->AtEnd()) scanner->Fail("the file ends before its last camera");
  NvmCamera camera;
  camera.line = scanner->line();
  const std::string_view line = scanner->RestOfLine();
  size_t end = line.find_last_not_of(kBlanks) + 1;
  size_t begin = end;
  for (int word = 0; word < 10; ++word) {
    end = line.substr(0, begin).find_last_not_of(kBlanks) + 1;
    begin = line.substr(0, end).find_last_of(kBlanks) + 1;
    if (begin == 0) scanner->Fail("a camera is a name and ten numbers");
  }
  camera.name = line.substr(0, line.substr(0, begin).find_last_not_of(kBlanks) + 1);
  std::replace(camera.name.begin(), camera.name.end(), '"', ' ');
  TextScanner numbers(path, line.substr(begin), camera.line);
  camera.focal = numbers.FiniteNumber("focal length");
  for (double& q : camera.quaternion) q = numbers.FiniteNumber("quaternion");
  for (double& c : camera.center) c = numbers.FiniteNumber("camera center");
  camera.distortion = numbers.FiniteNumber("radial distortion");
  if (!(camera.focal > 0)) numbers.Fail("the focal length is not positive");
  return camera;
}

void SkipPoints(int count, TextScanner* scanner) {
  for (int i = 0; i < count; ++i) {
    if (scanner->AtEnd()) scanner->Fail("the file ends before its last point");
    scanner->RestOfLine();
  }
}

// Models follow each other until one has no images, or the file ends.
std::vector<NvmModel> ReadModels(const std::string& path, TextScanner* scanner) {
  std::vector<NvmModel> models;
  while (!scanner->AtEnd()) {
    const int num_cameras = scanner->Count("number of images");
    if (num_cameras == 0) break;
    std::vector<NvmCamera> cameras;
    for (int i = 0; i < num_cameras; ++i) cameras.push_back(ReadCamera(path, scanner));
    const int num_points = scanner->Count("number of points");
    models.push_back({std::move(cameras), num_points, *scanner});
    SkipPoints(num_points, scanner);
  }
  return models;
}

// The model of unregistered images that VisualSFM may append has no points: it counts least.
size_t ChooseModel(const std::vector<NvmModel>& models, int index, const std::string& path) {
  const FilePlace place{path, "model", static_cast<uint64_t>(std::max(index, 0))};
  if (models.empty()) place.Fail("the file holds no model");
  if (index >= static_cast<int>(models.size())) {
    place.Fail("there are only " + std::to_string(models.size()) + " models, counted from 0");
  }
  if (index >= 0) return static_cast<size_t>(index);
  const auto rank = [](const NvmModel& model) {
    return std::pair(model.num_points > 0, model.cameras.size());
  };
  const auto best =
      std::max_element(models.begin(), models.end(),
                       [&](const NvmModel& a, const NvmModel& b) { return rank(a) < rank(b); });
  return static_cast<size_t>(best - models.begin());
}

Camera ToCamera(const NvmCamera& nvm, const ImageSize& size, const FilePlace& place) {
  Camera camera;
  camera.width = static_cast<uint64_t>(size.width);
  camera.height = static_cast<uint64_t>(size.height);
  const double cx = 0.5 * size.width;
  const double cy = 0.5 * size.height;
  if (nvm.distortion == 0) {
    camera.model = CameraModelId::kSimplePinhole;
    camera.params = {nvm.focal, cx, cy};
    return camera;
  }
  const auto inverted = InvertMeasurementDistortion(nvm.distortion, std::hypot(cx, cy) / nvm.focal);
  if (!inverted || inverted->max_error * nvm.focal > kMaxDistortionErrorPx) {
    place.Fail("the radial distortion " + std::to_string(nvm.distortion) +
               " is too strong for COLMAP's cameras");
  }
  camera.model = CameraModelId::kFullOpencv;
  camera.params = {nvm.focal, nvm.focal, cx, cy};
  camera.params.insert(camera.params.end(), inverted->extra.begin(), inverted->extra.end());
  return camera;
}

ImageOfCamera AddImages(const std::vector<NvmCamera>& cameras, const std::string& path,
                        ImageFolder* images, ImportedScene* scene) {
  ImageOfCamera image_of_camera(cameras.size(), -1);
  for (size_t i = 0; i < cameras.size(); ++i) {
    const NvmCamera& camera = cameras[i];
    ImportedImage image;
    image.path = path;
    image.number = static_cast<uint64_t>(camera.line);
    const FilePlace place{image.path, "line", image.number};
    const auto found = images->Find(camera.name, fs::path(path).parent_path(), place);
    if (!found) continue;
    image.name = found->name;
    image.camera = ToCamera(camera, found->size, place);
    image.cam_from_world = MakePose(camera.quaternion, camera.center, camera.name, place);
    image.cam_from_world.translation = -(image.cam_from_world.rotation * camera.center);
    image_of_camera[i] = static_cast<int>(scene->images.size());
    scene->images.push_back(std::move(image));
  }
  return image_of_camera;
}

void PlaceMeasurements(ImportedScene* scene) {
  const auto is_negative = [](const Observation& o) { return o.position.minCoeff() < 0; };
  const bool from_center =
      std::any_of(scene->images.begin(), scene->images.end(), [&](const ImportedImage& image) {
        return std::any_of(image.observations.begin(), image.observations.end(), is_negative);
      });
  if (!from_center && !scene->points.empty()) {
    scene->notes.push_back(
        "No measurement is negative: they are from the corner of the image, as COLMAP writes them");
  }
  if (!from_center) return;
  for (ImportedImage& image : scene->images) {
    const Eigen::Vector2d size(static_cast<double>(image.camera.width),
                               static_cast<double>(image.camera.height));
    for (Observation& observation : image.observations) observation.position += 0.5 * size;
  }
}

}  // namespace

bool HoldsNvm(const fs::path& path) { return HoldsFile(path, kNvmEnds); }

ImportedScene ReadNvm(const ImportInput& input) {
  const std::string path = TheFile(input.path, kNvmEnds).string();
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  if (scanner.Word("the header NVM_V3") != kNvmHeader) scanner.Fail("\"NVM_V3\" expected");
  if (!scanner.AtEndOfLine()) {
    scanner.Fail("\"NVM_V3 " + std::string(scanner.RestOfLine().substr(0, 40)) +
                 "\": a fixed calibration is not read; export without it");
  }
  std::vector<NvmModel> models = ReadModels(path, &scanner);
  const size_t chosen = ChooseModel(models, input.model_index, path);
  ImportedScene scene;
  scene.notes = {"Read " + path + ", model " + std::to_string(chosen) + " of " +
                 std::to_string(models.size()) + " (counted from 0)"};
  NvmModel& model = models[chosen];
  const ImageOfCamera image_of_camera = AddImages(model.cameras, path, input.images, &scene);
  SetPoints(ReadTrackedPoints(model.num_points, image_of_camera, &model.points), &scene);
  PlaceMeasurements(&scene);
  return scene;
}

}  // namespace limn::colmap_ext
