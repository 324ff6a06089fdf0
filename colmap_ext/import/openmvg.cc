#include "colmap_ext/import/openmvg.h"

#include <map>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/calibration.h"
#include "colmap_ext/import/json_members.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

// Objects behind a pointer, as the library that openMVG writes with stores them.
const Json& PointedTo(const Json& value, const FilePlace& place) {
  return ObjectMember(ObjectMember(value, "ptr_wrapper", place), "data", place);
}

struct OpenmvgCamera {
  std::string type;
  const Json* data = nullptr;
};

using OpenmvgCameras = std::map<uint64_t, OpenmvgCamera>;
using OpenmvgPoses = std::map<uint64_t, Rigid3d>;

// The first camera of a type has its name, the others its number. The highest bit only marks the
// first.
OpenmvgCameras ReadOpenmvgCameras(const Json& file, const std::string& path) {
  constexpr uint64_t kFirstOfType = uint64_t{1} << 31;
  OpenmvgCameras intrinsics;
  std::map<uint64_t, std::string> name_of_type;
  uint64_t number = 0;
  for (const Json& entry : ListMember(file, "intrinsics", {path, "line", 1})) {
    const FilePlace place{path, "camera", number++};
    const Json& value = ObjectMember(entry, "value", place);
    const uint64_t type = IndexMember(value, "polymorphic_id", place) & ~kFirstOfType;
    if (FindMember(value, "polymorphic_name")) {
      name_of_type[type] = TextMember(value, "polymorphic_name", place);
    }
    if (!name_of_type.contains(type)) place.Fail("no camera before it has its \"polymorphic_id\"");
    intrinsics[IndexMember(entry, "key", place)] = {name_of_type[type], &PointedTo(value, place)};
  }
  return intrinsics;
}

OpenmvgPoses ReadOpenmvgPoses(const Json& file, const std::string& path) {
  OpenmvgPoses poses;
  uint64_t number = 0;
  for (const Json& entry : ListMember(file, "extrinsics", {path, "line", 1})) {
    const FilePlace place{path, "pose", number++};
    const Json& value = ObjectMember(entry, "value", place);
    const Json& rows = ListMember(value, "rotation", place);
    if (rows.size() != 3) place.Fail("\"rotation\" is not 3 x 3");
    Eigen::Matrix3d rotation;
    for (int row = 0; row < 3; ++row) {
      const std::vector<double> numbers = NumbersOf(rows[row], "rotation", 3, place);
      rotation.row(row) = Eigen::RowVector3d::Map(numbers.data());
    }
    const std::vector<double> numbers = NumbersMember(value, "center", 3, place);
    const Eigen::Vector3d center = Eigen::Vector3d::Map(numbers.data());
    Rigid3d pose;
    pose.rotation = RotationFromMatrix(rotation, place);
    pose.translation = -(pose.rotation * center);
    poses[IndexMember(entry, "key", place)] = pose;
  }
  return poses;
}

// The size of the camera is set.
void SetOpenmvgLens(const OpenmvgCamera& intrinsic, const FilePlace& place, Camera* camera) {
  const Json& data = *intrinsic.data;
  const std::string& type = intrinsic.type;
  const double focal = NumberMember(data, "focal_length", place);
  const std::vector<double> center = NumbersMember(data, "principal_point", 2, place);
  const auto numbers = [&](const char* key, size_t count) {
    return NumbersMember(data, key, count, place);
  };
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
  OpenmvgReader(const Json& file, const std::string& path, ImageFolder* images)
      : file_(file),
        path_(path),
        images_(*images),
        intrinsics_(ReadOpenmvgCameras(file, path)),
        poses_(ReadOpenmvgPoses(file, path)) {}

  ImportedScene Read() {
    scene_.notes = {"Read " + path_};
    uint64_t number = 0;
    for (const Json& entry : ListMember(file_, "views", {path_, "line", 1})) {
      ReadView(entry, {path_, "view", number++});
    }
    if (scene_.images.empty() && num_without_pose_ > 0) {
      FilePlace{path_, "line", 1}.Fail(
          "none of its views has a pose: it is of before the reconstruction, which has another");
    }
    if (num_without_pose_ > 0) {
      scene_.notes.push_back(std::to_string(num_without_pose_) +
                             " views have no pose and are left out");
    }
    if (const Json* structure = FindMember(file_, "structure")) ReadPoints(*structure);
    return std::move(scene_);
  }

 private:
  fs::path Base() const {
    const Json* root = FindMember(file_, "root_path");
    const fs::path folder = fs::path(path_).parent_path();
    return root && root->is_string() ? folder / root->get<std::string>() : folder;
  }

  void ReadView(const Json& entry, const FilePlace& place) {
    const Json& data = PointedTo(ObjectMember(entry, "value", place), place);
    const auto pose = poses_.find(IndexMember(data, "id_pose", place));
    const auto intrinsic = intrinsics_.find(IndexMember(data, "id_intrinsic", place));
    if (pose == poses_.end() || intrinsic == intrinsics_.end()) {
      ++num_without_pose_;
      return;
    }
    const fs::path local =
        FindMember(data, "local_path") ? TextMember(data, "local_path", place) : std::string();
    const auto found =
        images_.Find((local / TextMember(data, "filename", place)).generic_string(), Base(), place);
    if (!found) return;
    ImportedImage image;
    image.path = path_;
    image.unit = place.unit;
    image.number = place.number;
    image.name = found->name;
    const Json& camera = *intrinsic->second.data;
    SetStatedSize(NumberMember(camera, "width", place), NumberMember(camera, "height", place),
                  *found, place, &image);
    SetOpenmvgLens(intrinsic->second, place, &image.camera);
    image.cam_from_world = pose->second;
    image_of_view_[IndexMember(data, "id_view", place)] = scene_.images.size();
    scene_.images.push_back(std::move(image));
  }

  void ReadPoints(const Json& structure) {
    if (!structure.is_array()) {
      FilePlace{path_, "line", 1}.Fail("\"structure\" is not a list");
    }
    uint64_t number = 0;
    for (const Json& entry : structure) {
      const FilePlace place{path_, "point", number++};
      const Json& value = ObjectMember(entry, "value", place);
      const std::vector<double> position = NumbersMember(value, "X", 3, place);
      ModelPoint point;
      point.id = scene_.points.size() + 1;
      point.position = Eigen::Vector3d::Map(position.data());
      for (const Json& observation : ListMember(value, "observations", place)) {
        AddMeasurement(observation, place, &point);
      }
      scene_.points.push_back(std::move(point));
    }
  }

  void AddMeasurement(const Json& observation, const FilePlace& place, ModelPoint* point) {
    const auto found = image_of_view_.find(IndexMember(observation, "key", place));
    if (found == image_of_view_.end()) return;
    const std::vector<double> pixel =
        NumbersMember(ObjectMember(observation, "value", place), "x", 2, place);
    std::vector<Observation>& observations = scene_.images[found->second].observations;
    point->track.push_back(
        {static_cast<uint32_t>(found->second + 1), static_cast<uint32_t>(observations.size())});
    observations.push_back({{pixel[0], pixel[1]}, point->id});
  }

  const Json& file_;
  const std::string& path_;
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
  const std::string path = TheCameraFile(input.path, kOpenmvgType).string();
  const Json file = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes), kMaxLargeJsonValues);
  return OpenmvgReader(file, path, input.images).Read();
}

}  // namespace limn::colmap_ext
