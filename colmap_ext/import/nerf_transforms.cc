#include "colmap_ext/import/nerf_transforms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/calibration.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

const std::vector<std::string> kTransformsEnds = {"transforms.json", "transforms_train.json",
                                                  "transforms_test.json", "transforms_val.json"};

// An entry of a frame, or of the whole file.
class Entries {
 public:
  Entries(const Json& frame, const Json& file) : frame_(frame), file_(file) {}

  const Json* Find(const char* key) const {
    for (const Json* json : {&frame_, &file_}) {
      const auto found = json->find(key);
      if (found != json->end() && !found->is_null()) return &*found;
    }
    return nullptr;
  }
  std::optional<double> Number(const char* key) const {
    const Json* found = Find(key);
    return found ? std::optional(found->get<double>()) : std::nullopt;
  }
  double NumberOr(const char* key, double otherwise) const {
    return Number(key).value_or(otherwise);
  }

 private:
  const Json& frame_;
  const Json& file_;
};

void CheckSize(const Entries& entries, const FoundImage& image, const FilePlace& place) {
  const double width = entries.NumberOr("w", image.size.width);
  const double height = entries.NumberOr("h", image.size.height);
  if (width == image.size.width && height == image.size.height) return;
  place.Fail("image \"" + image.name + "\" has " + std::to_string(image.size.width) + " x " +
             std::to_string(image.size.height) + " pixels, but w and h are " +
             std::to_string(std::lround(width)) + " and " + std::to_string(std::lround(height)));
}

std::optional<double> Focal(const Entries& entries, const char* focal_key, const char* angle_key,
                            int size) {
  if (const auto focal = entries.Number(focal_key)) return focal;
  const auto angle = entries.Number(angle_key);
  if (!angle) return std::nullopt;
  return 0.5 * size / std::tan(0.5 * *angle);
}

bool IsFisheye(const Entries& entries, const FilePlace& place) {
  const Json* fisheye = entries.Find("is_fisheye");
  if (fisheye && fisheye->get<bool>()) return true;
  const Json* model = entries.Find("camera_model");
  if (!model) return false;
  const auto name = model->get<std::string>();
  if (name == "OPENCV_FISHEYE") return true;
  for (const char* known : {"PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV"}) {
    if (name == known) return false;
  }
  place.Fail("camera_model \"" + name + "\" is not known");
}

// Model and extra parameters.
void SetDistortion(const Entries& entries, const FilePlace& place, Camera* camera) {
  const auto k = [&](const char* key) { return entries.NumberOr(key, 0); };
  const double k1 = k("k1"), k2 = k("k2"), k3 = k("k3"), k4 = k("k4"), p1 = k("p1"), p2 = k("p2");
  std::vector<double> extra;
  if (IsFisheye(entries, place)) {
    if (p1 != 0 || p2 != 0) place.Fail("a fisheye camera with p1 or p2: COLMAP has none");
    camera->model = CameraModelId::kOpencvFisheye;
    extra = {k1, k2, k3, k4};
  } else if (k4 != 0) {
    place.Fail("a k4 without fisheye: COLMAP has no such camera");
  } else if (k3 != 0) {
    camera->model = CameraModelId::kFullOpencv;
    extra = {k1, k2, p1, p2, k3, 0, 0, 0};
  } else if (k1 != 0 || k2 != 0 || p1 != 0 || p2 != 0) {
    camera->model = CameraModelId::kOpencv;
    extra = {k1, k2, p1, p2};
  }
  camera->params.insert(camera->params.end(), extra.begin(), extra.end());
}

Camera ReadCamera(const Entries& entries, const FoundImage& image, const FilePlace& place) {
  CheckSize(entries, image, place);
  Camera camera;
  camera.width = static_cast<uint64_t>(image.size.width);
  camera.height = static_cast<uint64_t>(image.size.height);
  const auto fx = Focal(entries, "fl_x", "camera_angle_x", image.size.width);
  if (!fx) place.Fail("neither fl_x nor camera_angle_x");
  const auto fy = Focal(entries, "fl_y", "camera_angle_y", image.size.height);
  camera.params = {*fx, fy.value_or(*fx), entries.NumberOr("cx", 0.5 * image.size.width),
                   entries.NumberOr("cy", 0.5 * image.size.height)};
  SetDistortion(entries, place, &camera);
  return camera;
}

Rigid3d ReadPose(const Json& matrix, const FilePlace& place) {
  if (matrix.size() != 3 && matrix.size() != 4) place.Fail("transform_matrix must be 4 x 4");
  Eigen::Matrix4d world_from_cam = Eigen::Matrix4d::Identity();
  for (int row = 0; row < static_cast<int>(matrix.size()); ++row) {
    if (matrix.at(row).size() != 4) place.Fail("transform_matrix must be 4 x 4");
    for (int column = 0; column < 4; ++column) {
      world_from_cam(row, column) = matrix.at(row).at(column).get<double>();
    }
  }
  if (!(world_from_cam.row(3).transpose() - Eigen::Vector4d::UnitW()).isZero(1e-9)) {
    place.Fail("the last row of transform_matrix is not 0 0 0 1");
  }
  const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
  const Eigen::Matrix3d rotation = world_from_cam.topLeftCorner<3, 3>() * turn;
  return Inverse({RotationFromMatrix(rotation, place), world_from_cam.topRightCorner<3, 1>()});
}

std::string ImageName(const Json& frame) {
  const auto name = frame.at("file_path").get<std::string>();
  return fs::path(name).has_extension() ? name : name + ".png";
}

// Relative to the file, as nerfstudio writes it, or to the folder of images.
std::string MaskOf(const Json& frame, const FilePlace& place, const ImageFolder& images) {
  const auto found = frame.find("mask_path");
  if (found == frame.end() || found->is_null()) return "";
  if (!found->is_string()) place.Fail("mask_path is not a text");
  auto name = found->get<std::string>();
  if (name.empty()) return "";
  std::ranges::replace(name, '\\', '/');
  std::error_code ignored;
  for (const fs::path& folder : {fs::path(place.path).parent_path(), images.path()}) {
    if (fs::is_regular_file(folder / name, ignored)) return (folder / name).string();
  }
  place.Fail("mask \"" + name + "\" is missing: correct or remove its mask_path");
}

std::optional<ImportedImage> ReadFrame(const Json& frame, const Json& file, const FilePlace& place,
                                       ImageFolder* images) {
  const auto found = images->Find(ImageName(frame), fs::path(place.path).parent_path(), place);
  if (!found) return std::nullopt;
  ImportedImage image;
  image.path = place.path;
  image.unit = place.unit;
  image.number = place.number;
  image.name = found->name;
  image.camera = ReadCamera(Entries(frame, file), *found, place);
  image.cam_from_world = ReadPose(frame.at("transform_matrix"), place);
  image.mask = MaskOf(frame, place, *images);
  return image;
}

Json Parse(const std::string& path) {
  try {
    const Json file = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes));
    if (!file.at("frames").is_array()) throw IoError(path, "\"frames\" is not a list");
    if (file.value("from_na", false)) {
      throw IoError(path, "\"from_na\" is true: the axes of NeuS2 are not read");
    }
    return file;
  } catch (const Json::exception& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace

bool HoldsNerfTransforms(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path.extension() == ".json";
  return HoldsFile(path, kTransformsEnds);
}

ImportedScene ReadNerfTransforms(const ImportInput& input) {
  const std::string path = TheFile(input.path, kTransformsEnds).string();
  const Json file = Parse(path);
  ImportedScene scene;
  scene.notes = {"Read " + path};
  if (file.contains("ply_file_path")) scene.notes.push_back("The points of its .ply are not read");
  uint64_t number = 0;
  for (const Json& frame : file.at("frames")) {
    const FilePlace place{path, "frame", number++};
    try {
      auto image = ReadFrame(frame, file, place, input.images);
      if (image) scene.images.push_back(std::move(*image));
    } catch (const Json::exception& error) {
      place.Fail(error.what());
    }
  }
  return scene;
}

}  // namespace limn::colmap_ext
