// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/openmvg.h"

#include <map>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/json_scene.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/formats/json_place.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Objects behind a pointer, as the library that openMVG writes with stores them.
JsonValue PointedTo(const JsonValue& value) { return value.At("ptr_wrapper").At("data"); }

struct OpenmvgCamera {
  std::string type;
  JsonValue data;
};

using OpenmvgCameras = std::map<uint64_t, OpenmvgCamera>;
using OpenmvgPoses = std::map<uint64_t, Rigid3d>;

// The first camera of a type has its name, the others its number. The highest bit only marks the
// first.
OpenmvgCameras ReadOpenmvgCameras(const JsonValue& file) {
  constexpr uint64_t kFirstOfType = uint64_t{1} << 31;
  OpenmvgCameras intrinsics;
  std::map<uint64_t, std::string> name_of_type;
  for (const JsonValue& entry : file.At("intrinsics").Items()) {
    const JsonValue value = entry.At("value");
    const uint64_t type = value.At("polymorphic_id").Index() & ~kFirstOfType;
    if (const auto name = value.FindNonNull("polymorphic_name")) name_of_type[type] = name->Text();
    if (!name_of_type.contains(type)) value.Fail("no camera before it has its \"polymorphic_id\"");
    intrinsics.insert_or_assign(entry.At("key").Index(),
                                OpenmvgCamera{name_of_type[type], PointedTo(value)});
  }
  return intrinsics;
}

OpenmvgPoses ReadOpenmvgPoses(const JsonValue& file, const std::string& path) {
  OpenmvgPoses poses;
  uint64_t number = 0;
  for (const JsonValue& entry : file.At("extrinsics").Items()) {
    const JsonValue value = entry.At("value");
    const std::vector<JsonValue> rows = value.At("rotation").Items(3, 3);
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation;
    for (int row = 0; row < 3; ++row) rows[row].Numbers(3, rotation.row(row).data());
    Rigid3d pose;
    pose.rotation = RotationFromMatrix(rotation, {path, "pose", number++});
    pose.translation = -(pose.rotation * PlaceOf(value.At("center")));
    poses[entry.At("key").Index()] = pose;
  }
  return poses;
}

// The size of the camera is set.
void SetOpenmvgLens(const OpenmvgCamera& intrinsic, const FilePlace& place, Camera* camera) {
  const std::string& type = intrinsic.type;
  const auto numbers = [&](const char* key, size_t count) {
    std::vector<double> read(count);
    intrinsic.data.At(key).Numbers(count, read.data());
    return read;
  };
  const double focal = intrinsic.data.At("focal_length").Number();
  const std::vector<double> center = numbers("principal_point", 2);
  if (type == "pinhole" || type == "pinhole_radial_k1") {
    camera->params = {focal, center[0], center[1]};
    camera->model = CameraModelId::kSimplePinhole;
    const double k1 = type == "pinhole" ? 0 : numbers("disto_k1", 1)[0];
    if (k1 == 0) return;
    camera->model = CameraModelId::kSimpleRadial;
    camera->params.push_back(k1);
    return;
  }
  camera->params = {focal, focal, center[0], center[1]};
  if (type == "pinhole_radial_k3") {
    const std::vector<double> k = numbers("disto_k3", 3);
    SetBrownLens({{k[0], k[1], k[2], 0}, 0, 0}, place, camera);
  } else if (type == "pinhole_brown_t2") {
    const std::vector<double> k = numbers("disto_t2", 5);
    SetBrownLens({{k[0], k[1], k[2], 0}, k[3], k[4]}, place, camera);
  } else if (type == "fisheye") {
    const std::vector<double> k = numbers("fisheye", 4);
    SetFisheyeLens({{k[0], k[1], k[2], k[3]}, 0, 0}, camera);
  } else {
    place.Fail("cameras of type \"" + type +
               "\" are not read: openMVG_main_ExportUndistortedImages writes pinhole images");
  }
}

class OpenmvgReader {
 public:
  OpenmvgReader(const JsonValue& file, const std::string& path, ImageFolder* images)
      : file_(file),
        path_(path),
        base_(BaseOf(file, path)),
        images_(*images),
        intrinsics_(ReadOpenmvgCameras(file)),
        poses_(ReadOpenmvgPoses(file, path)) {}

  ImportedScene Read() {
    scene_.notes = {"Read " + path_};
    uint64_t number = 0;
    for (const JsonValue& entry : file_.At("views").Items()) {
      ReadView(entry, {path_, "view", number++});
    }
    if (scene_.images.empty() && num_without_pose_ > 0) {
      file_.Fail(
          "none of its views has a pose: it is of before the reconstruction, which has another");
    }
    if (num_without_pose_ > 0) {
      scene_.notes.push_back(std::to_string(num_without_pose_) +
                             " views have no pose and are left out");
    }
    if (const auto structure = file_.FindNonNull("structure")) ReadPoints(*structure);
    return std::move(scene_);
  }

 private:
  static fs::path BaseOf(const JsonValue& file, const std::string& path) {
    const auto root = file.FindNonNull("root_path");
    const fs::path folder = fs::path(path).parent_path();
    return root ? folder / root->Text() : folder;
  }

  void ReadView(const JsonValue& entry, const FilePlace& place) {
    const JsonValue data = PointedTo(entry.At("value"));
    const auto pose = poses_.find(data.At("id_pose").Index());
    const auto intrinsic = intrinsics_.find(data.At("id_intrinsic").Index());
    if (pose == poses_.end() || intrinsic == intrinsics_.end()) {
      ++num_without_pose_;
      return;
    }
    fs::path name = data.At("filename").Text();
    if (const auto local = data.FindNonNull("local_path")) name = local->Text() / name;
    const auto found = images_.Find(name.generic_string(), base_, place);
    if (!found) return;
    ImportedImage image;
    image.path = path_;
    image.unit = place.unit;
    image.number = place.number;
    image.name = found->name;
    const JsonValue& camera = intrinsic->second.data;
    SetStatedSize(camera.At("width").Number(), camera.At("height").Number(), *found, place, &image);
    SetOpenmvgLens(intrinsic->second, place, &image.camera);
    image.cam_from_world = pose->second;
    image_of_view_[data.At("id_view").Index()] = scene_.images.size();
    scene_.images.push_back(std::move(image));
  }

  void ReadPoints(const JsonValue& structure) {
    for (const JsonValue& entry : structure.Items()) {
      const JsonValue value = entry.At("value");
      ModelPoint point;
      point.id = scene_.points.size() + 1;
      point.position = PlaceOf(value.At("X"));
      for (const JsonValue& observation : value.At("observations").Items()) {
        AddMeasurement(observation, &point);
      }
      scene_.points.push_back(std::move(point));
    }
  }

  void AddMeasurement(const JsonValue& observation, ModelPoint* point) {
    const auto found = image_of_view_.find(observation.At("key").Index());
    if (found == image_of_view_.end()) return;
    Eigen::Vector2d pixel;
    observation.At("value").At("x").Numbers(2, pixel.data());
    std::vector<Observation>& observations = scene_.images[found->second].observations;
    point->track.push_back(
        {static_cast<uint32_t>(found->second + 1), static_cast<uint32_t>(observations.size())});
    observations.push_back({pixel, point->id});
  }

  const JsonValue file_;
  const std::string& path_;
  const fs::path base_;
  ImageFolder& images_;
  const OpenmvgCameras intrinsics_;
  const OpenmvgPoses poses_;
  ImportedScene scene_;
  std::map<uint64_t, size_t> image_of_view_;
  size_t num_without_pose_ = 0;
};

}  // namespace

bool HoldsOpenmvg(const fs::path& path) { return HoldsCameraFile(path, kOpenmvgType); }

ImportedScene ReadOpenmvg(const ImportInput& input) {
  return ReadJsonScene(input.path, kOpenmvgType, kMaxLargeJsonValues,
                       [&](const JsonValue& file, const std::string& path) {
                         return OpenmvgReader(file, path, input.images).Read();
                       });
}

}  // namespace limn::colmap_ext
