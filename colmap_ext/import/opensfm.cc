// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/opensfm.h"

#include <algorithm>
#include <map>

#include "colmap_ext/import/brown_lens.h"
#include "colmap_ext/import/json_scene.h"
#include "colmap_ext/import/opensfm_tracks.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/camera_files.h"
#include "limn/files/json_text.h"
#include "limn/formats/json_place.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using OpensfmCameras = std::map<std::string, JsonValue>;

// The given index, or that of the one with the most shots if it is negative.
size_t ChooseReconstruction(const JsonValue& file, int index) {
  std::vector<size_t> num_shots;
  for (const JsonValue& one : file.Items()) num_shots.push_back(one.At("shots").Members().size());
  if (num_shots.empty()) file.Fail("no reconstruction in this file");
  if (index >= static_cast<int>(num_shots.size())) {
    file.Fail("there are only " + std::to_string(num_shots.size()) +
              " reconstructions, counted from 0");
  }
  if (index >= 0) return static_cast<size_t>(index);
  return static_cast<size_t>(std::ranges::max_element(num_shots) - num_shots.begin());
}

// Zero if it is missing.
double NumberOrZero(const JsonValue& object, const char* key) {
  const auto found = object.FindNonNull(key);
  return found ? found->Number() : 0;
}

// Appends model and parameters; the size of the camera is set.
class LensReader {
 public:
  LensReader(const JsonValue& json, const FilePlace& place, Camera* camera)
      : json_(json),
        place_(place),
        camera_(*camera),
        longer_side_(static_cast<double>(std::max(camera->width, camera->height))) {}

  void Read() {
    const auto type = json_.FindNonNull("projection_type");
    const std::string name = type ? type->Text() : "perspective";
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
  double Focal(const char* key) const { return longer_side_ * json_.At(key).Number(); }
  double Extra(const char* key) const { return NumberOrZero(json_, key); }

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

  const JsonValue& json_;
  const FilePlace& place_;
  Camera& camera_;
  const double longer_side_;
};

Rigid3d ReadShotPose(const JsonValue& shot) {
  const Eigen::Vector3d axis = PlaceOf(shot.At("rotation"));
  const double angle = axis.norm();
  Rigid3d cam_from_world;
  if (angle > 0) cam_from_world.rotation = Eigen::AngleAxisd(angle, axis / angle);
  cam_from_world.translation = PlaceOf(shot.At("translation"));
  return cam_from_world;
}

std::optional<ImportedImage> ReadShot(const std::string& name, const JsonValue& shot,
                                      const OpensfmCameras& cameras, const FilePlace& place,
                                      ImageFolder* images) {
  const auto found = images->Find(name, fs::path(place.path).parent_path() / "images", place);
  if (!found) return std::nullopt;
  const std::string& id = shot.At("camera").Text();
  const auto camera = cameras.find(id);
  if (camera == cameras.end()) place.Fail("camera \"" + id + "\" is not among the cameras");
  ImportedImage image;
  image.path = place.path;
  image.unit = place.unit;
  image.number = place.number;
  image.name = found->name;
  const double width = NumberOrZero(camera->second, "width");
  const double height = NumberOrZero(camera->second, "height");
  if (width == 0 && height == 0) {
    SetSizeOfFile(*found, &image);
  } else {
    SetStatedSize(width, height, *found, place, &image);
  }
  LensReader(camera->second, place, &image.camera).Read();
  image.cam_from_world = ReadShotPose(shot);
  return image;
}

void ReadOpensfmPoints(const JsonValue& reconstruction,
                       const std::map<std::string, int>& image_of_shot, const std::string& path,
                       ImportedScene* scene) {
  const auto found = reconstruction.FindNonNull("points");
  if (!found) return;
  const auto points = found->Members();
  if (points.empty()) return;
  const fs::path tracks = fs::path(path).parent_path() / "tracks.csv";
  std::error_code ignored;
  if (!fs::is_regular_file(tracks, ignored)) {
    scene->notes.push_back(
        "Its points are left out: tracks.csv, which tells their images, is "
        "not beside the file");
    return;
  }
  std::map<std::string, size_t> index_of_track;
  for (const auto& [id, point] : points) {
    ModelPoint read;
    read.id = scene->points.size() + 1;
    read.position = PlaceOf(point.At("coordinates"));
    if (const auto color = point.FindNonNull("color")) {
      std::ranges::transform(PlaceOf(*color), read.color.begin(), [](double channel) {
        return static_cast<uint8_t>(std::clamp(channel, 0.0, 255.0));
      });
    }
    index_of_track.emplace(id, scene->points.size());
    scene->points.push_back(std::move(read));
  }
  AddOpensfmTracks(tracks.string(), image_of_shot, index_of_track, scene);
}

ImportedScene ReadReconstruction(const JsonValue& file, const std::string& path,
                                 const ImportInput& input) {
  const std::vector<JsonValue> all = file.Items();
  const size_t index = ChooseReconstruction(file, input.model_index);
  const auto members = all[index].At("cameras").Members();
  const OpensfmCameras cameras(members.begin(), members.end());
  ImportedScene scene;
  scene.notes = {"Read " + path + ", reconstruction " + std::to_string(index) + " of " +
                 std::to_string(all.size()) + " (counted from 0)"};
  std::map<std::string, int> image_of_shot;
  uint64_t number = 0;
  for (const auto& [name, shot] : all[index].At("shots").Members()) {
    auto image = ReadShot(name, shot, cameras, {path, "shot", number++}, input.images);
    if (!image) continue;
    image_of_shot[name] = static_cast<int>(scene.images.size());
    scene.images.push_back(std::move(*image));
  }
  ReadOpensfmPoints(all[index], image_of_shot, path, &scene);
  return scene;
}

}  // namespace

bool HoldsOpensfm(const fs::path& path) { return HoldsCameraFile(path, kOpensfmType); }

ImportedScene ReadOpensfm(const ImportInput& input) {
  return ReadJsonScene(input.path, kOpensfmType, kMaxLargeJsonValues,
                       [&](const JsonValue& file, const std::string& path) {
                         return ReadReconstruction(file, path, input);
                       });
}

}  // namespace limn::colmap_ext
