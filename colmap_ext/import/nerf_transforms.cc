#include "colmap_ext/import/nerf_transforms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/calibration.h"
#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTransformsEnds = {"transforms.json", "transforms_train.json",
                                                  "transforms_test.json", "transforms_val.json"};

// An entry of a frame, or of the whole file.
class Entries {
 public:
  Entries(const JsonValue& frame, const JsonValue& file) : frame_(frame), file_(file) {}

  std::optional<JsonValue> Find(const char* key) const {
    for (const JsonValue& value : {frame_, file_}) {
      const auto found = value.Find(key);
      if (found && !found->IsNull()) return found;
    }
    return std::nullopt;
  }
  std::optional<double> Number(const char* key) const {
    const auto found = Find(key);
    return found ? std::optional(found->Number()) : std::nullopt;
  }
  double NumberOr(const char* key, double otherwise) const {
    return Number(key).value_or(otherwise);
  }

 private:
  JsonValue frame_;
  JsonValue file_;
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
  const auto fisheye = entries.Find("is_fisheye");
  if (fisheye && fisheye->Bool()) return true;
  const auto model = entries.Find("camera_model");
  if (!model) return false;
  const std::string& name = model->Text();
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

Rigid3d ReadPose(const JsonValue& matrix, const FilePlace& place) {
  const std::vector<JsonValue> rows = matrix.Items(3, 4);
  Eigen::Matrix4d world_from_cam = Eigen::Matrix4d::Identity();
  for (size_t row = 0; row < rows.size(); ++row) {
    Eigen::RowVector4d numbers;
    rows[row].Numbers(4, numbers.data());
    world_from_cam.row(static_cast<Eigen::Index>(row)) = numbers;
  }
  if (!(world_from_cam.row(3).transpose() - Eigen::Vector4d::UnitW()).isZero(1e-9)) {
    place.Fail("the last row of transform_matrix is not 0 0 0 1");
  }
  const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
  const Eigen::Matrix3d rotation = world_from_cam.topLeftCorner<3, 3>() * turn;
  return Inverse({RotationFromMatrix(rotation, place), world_from_cam.topRightCorner<3, 1>()});
}

std::string ImageName(const JsonValue& frame) {
  const std::string& name = frame.At("file_path").Text();
  return fs::path(name).has_extension() ? name : name + ".png";
}

std::optional<ImportedImage> ReadFrame(const JsonValue& frame, const JsonValue& file,
                                       const FilePlace& place, ImageFolder* images) {
  const auto found = images->Find(ImageName(frame), fs::path(place.path).parent_path(), place);
  if (!found) return std::nullopt;
  ImportedImage image;
  image.path = place.path;
  image.unit = place.unit;
  image.number = place.number;
  image.name = found->name;
  image.camera = ReadCamera(Entries(frame, file), *found, place);
  image.cam_from_world = ReadPose(frame.At("transform_matrix"), place);
  return image;
}

ImportedScene ToScene(const std::string& path, const JsonValue& file, ImageFolder* images) {
  ImportedScene scene;
  scene.notes = {"Read " + path};
  const std::vector<JsonValue> frames = file.At("frames").Items();
  if (file.BoolOr("from_na", false)) {
    throw IoError(path, "\"from_na\" is true: the axes of NeuS2 are not read");
  }
  if (file.Find("ply_file_path")) scene.notes.push_back("The points of its .ply are not read");
  uint64_t number = 0;
  for (const JsonValue& frame : frames) {
    auto image = ReadFrame(frame, file, {path, "frame", number++}, images);
    if (image) scene.images.push_back(std::move(*image));
  }
  return scene;
}

}  // namespace

bool HoldsNerfTransforms(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path.extension() == ".json";
  return HoldsFile(path, kTransformsEnds);
}

ImportedScene ReadNerfTransforms(const ImportInput& input) {
  const std::string path = TheFile(input.path, kTransformsEnds).string();
  try {
    const auto json = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes));
    return ToScene(path, JsonValue(json), input.images);
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

}  // namespace limn::colmap_ext
