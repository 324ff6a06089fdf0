#include "colmap_ext/import/nerf_transforms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/json_members.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

// Entries of a frame, else of the whole file.
class Entries {
 public:
  Entries(const Json& frame, const Json& file, const FilePlace& place)
      : frame_(frame), file_(file), place_(place) {}

  const FilePlace& place() const { return place_; }
  bool Has(const char* key) const { return FindMember(frame_, key) || FindMember(file_, key); }
  std::optional<double> Number(const char* key) const {
    return Has(key) ? std::optional(NumberMember(Holder(key), key, place_)) : std::nullopt;
  }
  double NumberOr(const char* key, double otherwise) const {
    return Number(key).value_or(otherwise);
  }
  std::string Text(const char* key) const { return TextMember(Holder(key), key, place_); }
  bool Flag(const char* key) const { return FlagMemberOr(Holder(key), key, false, place_); }

 private:
  const Json& Holder(const char* key) const { return FindMember(frame_, key) ? frame_ : file_; }

  const Json& frame_;
  const Json& file_;
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
  if (entries.Flag("is_fisheye")) return true;
  if (!entries.Has("camera_model")) return false;
  const std::string name = entries.Text("camera_model");
  if (name == "OPENCV_FISHEYE") return true;
  for (const char* known : {"PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV"}) {
    if (name == known) return false;
  }
  entries.place().Fail("camera_model \"" + name + "\" is not known");
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

Rigid3d ReadTransform(const Json& frame, const FilePlace& place) {
  constexpr char kKey[] = "transform_matrix";
  const Json& matrix = ListMember(frame, kKey, place);
  if (matrix.size() != 3 && matrix.size() != 4) place.Fail("transform_matrix must be 4 x 4");
  Eigen::Matrix4d world_from_cam = Eigen::Matrix4d::Identity();
  for (int row = 0; row < static_cast<int>(matrix.size()); ++row) {
    const std::vector<double> numbers = NumbersOf(matrix.at(row), kKey, 4, place);
    world_from_cam.row(row) = Eigen::RowVector4d::Map(numbers.data());
  }
  if (!(world_from_cam.row(3).transpose() - Eigen::Vector4d::UnitW()).isZero(1e-9)) {
    place.Fail("the last row of transform_matrix is not 0 0 0 1");
  }
  const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
  const Eigen::Matrix3d rotation = world_from_cam.topLeftCorner<3, 3>() * turn;
  return Inverse({RotationFromMatrix(rotation, place), world_from_cam.topRightCorner<3, 1>()});
}

std::string ImageName(const Json& frame, const FilePlace& place) {
  const std::string name = TextMember(frame, "file_path", place);
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
  const auto found =
      images->Find(ImageName(frame, place), fs::path(place.path).parent_path(), place);
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

}  // namespace

bool HoldsNerfTransforms(const fs::path& path) {
  return HoldsCameraFile(path, kNerfTransformsType);
}

ImportedScene ReadNerfTransforms(const ImportInput& input) {
  const std::string path = TheCameraFile(input.path, kNerfTransformsType).string();
  const Json file = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes));
  const FilePlace start{path, "line", 1};
  const Json& frames = ListMember(file, "frames", start);
  if (FlagMemberOr(file, "from_na", false, start)) {
    start.Fail("\"from_na\" is true: the axes of NeuS2 are not read");
  }
  ImportedScene scene;
  scene.notes = {"Read " + path};
  if (FindMember(file, "ply_file_path")) {
    scene.notes.push_back("The points of its .ply are not read");
  }
  uint64_t number = 0;
  for (const Json& frame : frames) {
    auto image = ReadFrame(frame, file, {path, "frame", number++}, input.images);
    if (image) scene.images.push_back(std::move(*image));
  }
  return scene;
}

}  // namespace limn::colmap_ext
