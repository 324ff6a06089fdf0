// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/nerf_transforms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/json_scene.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using MembersOfFile = std::map<std::string, JsonValue>;

// Entries of a frame, else of the whole file.
class Entries {
 public:
  Entries(const JsonValue& frame, const MembersOfFile& file, const FilePlace& place)
      : frame_(frame), file_(file), place_(place) {}

  const FilePlace& place() const { return place_; }
  std::optional<JsonValue> Find(const char* key) const {
    if (const auto own = frame_.FindNonNull(key)) return own;
    const auto common = file_.find(key);
    if (common == file_.end() || common->second.IsNull()) return std::nullopt;
    return common->second;
  }
  std::optional<double> Number(const char* key) const {
    const auto found = Find(key);
    return found ? std::optional(found->Number()) : std::nullopt;
  }
  double NumberOr(const char* key, double otherwise) const {
    return Number(key).value_or(otherwise);
  }

 private:
  const JsonValue& frame_;
  const MembersOfFile& file_;
  const FilePlace& place_;
};

std::optional<double> Focal(const Entries& entries, const char* focal_key, const char* angle_key,
                            double size) {
  if (const auto focal = entries.Number(focal_key)) return focal;
  const auto angle = entries.Number(angle_key);
  if (!angle) return std::nullopt;
  return 0.5 * size / std::tan(0.5 * *angle);
}

bool IsFisheye(const Entries& entries) {
  const auto flag = entries.Find("is_fisheye");
  if (flag && flag->Bool()) return true;
  const auto model = entries.Find("camera_model");
  if (!model) return false;
  const std::string& name = model->Text();
  if (name == "OPENCV_FISHEYE") return true;
  for (const char* known : {"PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV"}) {
    if (name == known) return false;
  }
  model->FailUnknown("camera model");
}

void SetCamera(const Entries& entries, const FoundImage& found, ImportedImage* image) {
  SetStatedSize(entries.NumberOr("w", found.size.width), entries.NumberOr("h", found.size.height),
                found, entries.place(), image);
  Camera& camera = image->camera;
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  const auto fx = Focal(entries, "fl_x", "camera_angle_x", width);
  if (!fx) entries.place().Fail("neither fl_x nor camera_angle_x");
  const auto fy = Focal(entries, "fl_y", "camera_angle_y", height);
  camera.params = {*fx, fy.value_or(*fx), entries.NumberOr("cx", 0.5 * width),
                   entries.NumberOr("cy", 0.5 * height)};
  const auto extra = [&](const char* key) { return entries.NumberOr(key, 0); };
  const BrownLens lens = {
      {extra("k1"), extra("k2"), extra("k3"), extra("k4")}, extra("p1"), extra("p2")};
  if (IsFisheye(entries)) {
    SetFisheyeLens(lens, &camera);
  } else {
    SetBrownLens(lens, entries.place(), &camera);
  }
}

Rigid3d ReadTransform(const JsonValue& frame, const FilePlace& place) {
  const JsonValue matrix = frame.At("transform_matrix");
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> world_from_cam = Eigen::Matrix4d::Identity();
  const std::vector<JsonValue> rows = matrix.Items(3, 4);
  for (size_t i = 0; i < rows.size(); ++i) rows[i].Numbers(4, world_from_cam.row(i).data());
  if (!(world_from_cam.row(3).transpose() - Eigen::Vector4d::UnitW()).isZero(1e-9)) {
    matrix.Fail("the last row is not 0 0 0 1");
  }
  const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
  const Eigen::Matrix3d rotation = world_from_cam.topLeftCorner<3, 3>() * turn;
  return Inverse({RotationFromMatrix(rotation, place), world_from_cam.topRightCorner<3, 1>()});
}

std::string ImageName(const JsonValue& frame) {
  const std::string& name = frame.At("file_path").Text();
  return fs::path(name).has_extension() ? name : name + ".png";
}

// Relative to the file, as nerfstudio writes it, or to the folder of images.
std::string MaskOf(const JsonValue& frame, const FilePlace& place, const ImageFolder& images) {
  const auto found = frame.FindNonNull("mask_path");
  std::string name = found ? found->Text() : "";
  if (name.empty()) return "";
  std::ranges::replace(name, '\\', '/');
  std::error_code ignored;
  for (const fs::path& folder : {fs::path(place.path).parent_path(), images.path()}) {
    if (fs::is_regular_file(folder / name, ignored)) return (folder / name).string();
  }
  place.Fail("mask \"" + name + "\" is missing: correct or remove its mask_path");
}

std::optional<ImportedImage> ReadFrame(const JsonValue& frame, const MembersOfFile& file,
                                       const FilePlace& place, ImageFolder* images) {
  const auto found = images->Find(ImageName(frame), fs::path(place.path).parent_path(), place);
  if (!found) return std::nullopt;
  ImportedImage image;
  image.path = place.path;
  image.unit = place.unit;
  image.number = place.number;
  image.name = found->name;
  SetCamera(Entries(frame, file, place), *found, &image);
  image.cam_from_world = ReadTransform(frame, place);
  image.mask = MaskOf(frame, place, *images);
  return image;
}

ImportedScene ReadFrames(const JsonValue& file, const std::string& path, ImageFolder* images) {
  const std::vector<JsonValue> frames = file.At("frames").Items();
  const auto neus_axes = file.FindNonNull("from_na");
  if (neus_axes && neus_axes->Bool()) neus_axes->Fail("the axes of NeuS2 are not read");
  ImportedScene scene;
  scene.notes = {"Read " + path};
  if (file.FindNonNull("ply_file_path")) {
    scene.notes.push_back("The points of its .ply are not read");
  }
  const auto members = file.Members();
  const MembersOfFile by_name(members.begin(), members.end());
  uint64_t number = 0;
  for (const JsonValue& frame : frames) {
    auto image = ReadFrame(frame, by_name, {path, "frame", number++}, images);
    if (image) scene.images.push_back(std::move(*image));
  }
  return scene;
}

}  // namespace

bool HoldsNerfTransforms(const fs::path& path) {
  return HoldsCameraFile(path, kNerfTransformsType);
}

ImportedScene ReadNerfTransforms(const ImportInput& input) {
  return ReadJsonScene(input.path, kNerfTransformsType, kMaxJsonValues,
                       [&](const JsonValue& file, const std::string& path) {
                         return ReadFrames(file, path, input.images);
                       });
}

}  // namespace limn::colmap_ext
