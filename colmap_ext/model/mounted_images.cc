// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/mounted_images.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

namespace limn::colmap_ext {
namespace {

constexpr double kPoseTolerance = 1e-6;

bool Differs(const Rigid3d& a, const Rigid3d& b, double length_scale) {
  return a.rotation.angularDistance(b.rotation) > kPoseTolerance ||
         (a.translation - b.translation).norm() > kPoseTolerance * length_scale;
}

// Index of what has this id, the first if there are several.
template <typename Item>
std::unordered_map<uint32_t, size_t> IndexById(const std::vector<Item>& items) {
  std::unordered_map<uint32_t, size_t> index;
  for (size_t i = 0; i < items.size(); ++i) index.emplace(items[i].id, i);
  return index;
}

// Of an image of this camera; nothing if its pose in the rig is unknown.
std::optional<size_t> SensorOf(const Rig& rig, uint32_t camera_id) {
  const SensorId camera = {kCameraSensor, camera_id};
  const auto found = std::find_if(rig.sensors.begin(), rig.sensors.end(),
                                  [&](const RigSensor& sensor) { return sensor.sensor == camera; });
  if (found == rig.sensors.end() || !found->has_pose) return std::nullopt;
  return found - rig.sensors.begin();
}

// Index of the first frame of each image id, and how many images are in another one, too.
struct FramesOfImages {
  std::unordered_map<uint64_t, size_t> frame_of_image;
  int64_t num_in_two = 0;
};

FramesOfImages FindFrames(const SparseModel& model) {
  FramesOfImages found;
  for (size_t f = 0; f < model.frames.size(); ++f) {
    for (const FrameData& data : model.frames[f].data) {
      if (data.sensor.type != kCameraSensor) continue;
      found.num_in_two += !found.frame_of_image.emplace(data.id, f).second;
    }
  }
  return found;
}

void WarnIf(int64_t count, const std::string& text, SparseModel* model) {
  if (count > 0) model->warnings.push_back(std::to_string(count) + " " + text);
}

}  // namespace

std::vector<MountedImage> MountedImages(const SparseModel& model) {
  const auto rig_of_id = IndexById(model.rigs);
  const FramesOfImages frames = FindFrames(model);
  std::vector<MountedImage> mounted;
  for (size_t i = 0; i < model.images.size(); ++i) {
    const auto frame = frames.frame_of_image.find(model.images[i].id);
    if (frame == frames.frame_of_image.end()) continue;
    const auto rig = rig_of_id.find(model.frames[frame->second].rig_id);
    if (rig == rig_of_id.end()) continue;
    const auto sensor = SensorOf(model.rigs[rig->second], model.images[i].camera_id);
    if (sensor) mounted.push_back({i, frame->second, rig->second, *sensor});
  }
  return mounted;
}

std::set<size_t> ImagesOfSharedRigs(const std::set<size_t>& images, const SparseModel& model) {
  std::vector<MountedImage> mounted = MountedImages(model);
  std::erase_if(mounted, [&](const MountedImage& at) { return !images.contains(at.image); });
  std::map<size_t, std::set<size_t>> sensors_of_rig;
  for (const MountedImage& at : mounted) sensors_of_rig[at.rig].insert(at.sensor);
  std::set<size_t> shared;
  for (const MountedImage& at : mounted) {
    if (sensors_of_rig[at.rig].size() > 1) shared.insert(at.image);
  }
  return shared;
}

Rigid3d ComposedPose(const SparseModel& model, const MountedImage& mounted) {
  return model.rigs[mounted.rig].sensors[mounted.sensor].sensor_from_rig *
         model.frames[mounted.frame].rig_from_world;
}

void ApplyRigs(SparseModel* model) {
  int64_t num_changed = 0;
  const std::vector<MountedImage> mounted = MountedImages(*model);
  for (const MountedImage& at : mounted) {
    const Rigid3d composed = ComposedPose(*model, at);
    const double length_scale =
        model->rigs[at.rig].sensors[at.sensor].sensor_from_rig.translation.norm() +
        model->frames[at.frame].rig_from_world.translation.norm();
    Rigid3d& pose = model->images[at.image].cam_from_world;
    num_changed += Differs(composed, pose, length_scale);
    pose = composed;
  }
  WarnIf(num_changed, "image poses differ from those of rigs and frames, which were used", model);
  WarnIf(static_cast<int64_t>(model->images.size() - mounted.size()),
         "images have no pose by rigs and frames; that of the images file was kept", model);
  WarnIf(FindFrames(*model).num_in_two, "images are in two frames; the first one was used", model);
}

}  // namespace limn::colmap_ext
