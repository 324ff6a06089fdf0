#include "colmap_ext/import/opensfm.h"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/json_members.h"
#include "colmap_ext/import/opensfm_tracks.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

const Json& ChooseReconstruction(const Json& file, int index, const FilePlace& start) {
  if (!file.is_array()) start.Fail("not a list of reconstructions");
  if (file.empty()) start.Fail("no reconstruction in this file");
  for (const Json& one : file) ObjectMember(one, "shots", start);
  if (index >= static_cast<int>(file.size())) {
    start.Fail("there are only " + std::to_string(file.size()) +
               " reconstructions, counted from 0");
  }
  if (index >= 0) return file[static_cast<size_t>(index)];
  return *std::max_element(file.begin(), file.end(), [](const Json& a, const Json& b) {
    return a.at("shots").size() < b.at("shots").size();
  });
}

// Appends model and parameters; the size of the camera is set.
class LensReader {
 public:
  LensReader(const Json& json, const FilePlace& place, Camera* camera)
      : json_(json),
        place_(place),
        camera_(*camera),
        longer_side_(static_cast<double>(std::max(camera->width, camera->height))) {}

  void Read() {
    const Json* type = FindMember(json_, "projection_type");
    const std::string name = type ? TextMember(json_, "projection_type", place_) : "perspective";
    if (name == "perspective") {
      ReadPerspective();
    } else if (name == "simple_radial" || name == "radial" || name == "brown") {
      SetFocalsAndCenter();
      SetBrownLens({{Extra("k1"), Extra("k2"), Extra("k3"), 0}, Extra("p1"), Extra("p2")}, place_,
                   &camera_);
    } else if (name == "fisheye") {
      SetCenter({Focal("focal"), Focal("focal")});
      SetFisheyeLens({{Extra("k1"), Extra("k2"), 0, 0}, 0, 0}, &camera_);
    } else if (name == "fisheye_opencv") {
      SetFocalsAndCenter();
      SetFisheyeLens({{Extra("k1"), Extra("k2"), Extra("k3"), Extra("k4")}, 0, 0}, &camera_);
    } else {
      place_.Fail("cameras of type \"" + name +
                  "\" are not read: `opensfm undistort` writes others, with their images, into "
                  "undistorted/");
    }
  }

 private:
  double Focal(const char* key) const { return longer_side_ * NumberMember(json_, key, place_); }
  double Extra(const char* key) const { return NumberMemberOr(json_, key, 0, place_); }

  void SetCenter(std::vector<double> focals) {
    camera_.params = std::move(focals);
    camera_.params.push_back(0.5 * static_cast<double>(camera_.width) +
                             longer_side_ * Extra("c_x"));
    camera_.params.push_back(0.5 * static_cast<double>(camera_.height) +
                             longer_side_ * Extra("c_y"));
  }
  void SetFocalsAndCenter() { SetCenter({Focal("focal_x"), Focal("focal_y")}); }

  void ReadPerspective() {
    SetCenter({Focal("focal")});
    const double k1 = Extra("k1"), k2 = Extra("k2");
    camera_.model = CameraModelId::kSimplePinhole;
    if (k1 == 0 && k2 == 0) return;
    camera_.model = CameraModelId::kRadial;
    camera_.params.insert(camera_.params.end(), {k1, k2});
  }

  const Json& json_;
  const FilePlace& place_;
  Camera& camera_;
  const double longer_side_;
};

Rigid3d ReadShotPose(const Json& shot, const FilePlace& place) {
  const std::vector<double> turn = NumbersMember(shot, "rotation", 3, place);
  const std::vector<double> shift = NumbersMember(shot, "translation", 3, place);
  const Eigen::Vector3d axis = Eigen::Vector3d::Map(turn.data());
  const double angle = axis.norm();
  Rigid3d cam_from_world;
  if (angle > 0) cam_from_world.rotation = Eigen::AngleAxisd(angle, axis / angle);
  cam_from_world.translation = Eigen::Vector3d::Map(shift.data());
  return cam_from_world;
}

std::optional<ImportedImage> ReadShot(const std::string& name, const Json& shot,
                                      const Json& cameras, const FilePlace& place,
                                      ImageFolder* images) {
  const auto found = images->Find(name, fs::path(place.path).parent_path() / "images", place);
  if (!found) return std::nullopt;
  const std::string id = TextMember(shot, "camera", place);
  const Json* camera = FindMember(cameras, id.c_str());
  if (!camera) place.Fail("camera \"" + id + "\" is not among the cameras");
  ImportedImage image;
  image.path = place.path;
  image.unit = place.unit;
  image.number = place.number;
  image.name = found->name;
  const double width = NumberMemberOr(*camera, "width", 0, place);
  const double height = NumberMemberOr(*camera, "height", 0, place);
  if (width == 0 && height == 0) {
    SetSizeOfFile(*found, &image);
  } else {
    SetStatedSize(width, height, *found, place, &image);
  }
  LensReader(*camera, place, &image.camera).Read();
  image.cam_from_world = ReadShotPose(shot, place);
  return image;
}

void ReadOpensfmPoints(const Json& reconstruction, const std::map<std::string, int>& image_of_shot,
                       const std::string& path, ImportedScene* scene) {
  const FilePlace start{path, "line", 1};
  const Json* points = FindMember(reconstruction, "points");
  if (!points || points->empty()) return;
  if (!points->is_object()) start.Fail("\"points\" is not an object");
  const fs::path tracks = fs::path(path).parent_path() / "tracks.csv";
  std::error_code ignored;
  if (!fs::is_regular_file(tracks, ignored)) {
    scene->notes.push_back(
        "Its points are left out: tracks.csv, which tells their images, is "
        "not beside the file");
    return;
  }
  std::map<std::string, size_t> index_of_track;
  for (const auto& [id, point] : points->items()) {
    ModelPoint read;
    read.id = scene->points.size() + 1;
    const std::vector<double> position = NumbersMember(point, "coordinates", 3, start);
    read.position = Eigen::Vector3d::Map(position.data());
    if (FindMember(point, "color")) {
      const std::vector<double> color = NumbersMember(point, "color", 3, start);
      std::ranges::transform(color, read.color.begin(), [](double channel) {
        return static_cast<uint8_t>(std::clamp(channel, 0.0, 255.0));
      });
    }
    index_of_track.emplace(id, scene->points.size());
    scene->points.push_back(std::move(read));
  }
  AddOpensfmTracks(tracks.string(), image_of_shot, index_of_track, scene);
}

}  // namespace

bool HoldsOpensfm(const fs::path& path) { return HoldsCameraFile(path, kOpensfmType); }

ImportedScene ReadOpensfm(const ImportInput& input) {
  const std::string path = TheCameraFile(input.path, kOpensfmType).string();
  const Json file = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes), kMaxLargeJsonValues);
  const FilePlace start{path, "line", 1};
  const Json& chosen = ChooseReconstruction(file, input.model_index, start);
  const Json& cameras = ObjectMember(chosen, "cameras", start);
  ImportedScene scene;
  scene.notes = {"Read " + path + ", reconstruction " + std::to_string(&chosen - &file.front()) +
                 " of " + std::to_string(file.size()) + " (counted from 0)"};
  std::map<std::string, int> image_of_shot;
  uint64_t number = 0;
  for (const auto& [name, shot] : chosen.at("shots").items()) {
    auto image = ReadShot(name, shot, cameras, {path, "shot", number++}, input.images);
    if (!image) continue;
    image_of_shot[name] = static_cast<int>(scene.images.size());
    scene.images.push_back(std::move(*image));
  }
  ReadOpensfmPoints(chosen, image_of_shot, path, &scene);
  return scene;
}

}  // namespace limn::colmap_ext
