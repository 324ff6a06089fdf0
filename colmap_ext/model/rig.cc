#include "colmap_ext/model/rig.h"

#include <unordered_map>

namespace limn::colmap_ext {
namespace {

constexpr double kPoseTolerance = 1e-6;

bool Differs(const Rigid3d& a, const Rigid3d& b, double length_scale) {
  return a.rotation.angularDistance(b.rotation) > kPoseTolerance ||
         (a.translation - b.translation).norm() > kPoseTolerance * length_scale;
}

// Null if the pose of this camera in its rig is unknown.
const RigCamera* FindCamera(const std::unordered_map<uint32_t, const Rig*>& rigs, uint32_t rig_id,
                            uint32_t camera_id) {
  const auto rig = rigs.find(rig_id);
  if (rig == rigs.end()) return nullptr;
  const auto camera = rig->second->cameras.find(camera_id);
  if (camera == rig->second->cameras.end() || !camera->second.has_pose) return nullptr;
  return &camera->second;
}

void WarnIf(int64_t count, const std::string& text, SparseModel* model) {
  if (count > 0) model->warnings.push_back(std::to_string(count) + " " + text);
}

}  // namespace

void ApplyRigs(const std::vector<Rig>& rigs, const std::vector<Frame>& frames, SparseModel* model) {
  std::unordered_map<uint32_t, const Rig*> rig_of_id;
  for (const Rig& rig : rigs) rig_of_id.emplace(rig.id, &rig);
  std::unordered_map<uint64_t, const Frame*> frame_of_image;
  int64_t num_in_two_frames = 0;
  for (const Frame& frame : frames) {
    for (const uint64_t image_id : frame.image_ids) {
      num_in_two_frames += !frame_of_image.emplace(image_id, &frame).second;
    }
  }
  int64_t num_changed = 0;
  int64_t num_kept = 0;
  for (ModelImage& image : model->images) {
    const auto frame = frame_of_image.find(image.id);
    const RigCamera* camera = nullptr;
    if (frame != frame_of_image.end()) {
      camera = FindCamera(rig_of_id, frame->second->rig_id, image.camera_id);
    }
    if (!camera) {
      ++num_kept;
      continue;
    }
    const Rigid3d& rig_from_world = frame->second->rig_from_world;
    const Rigid3d composed = camera->cam_from_rig * rig_from_world;
    const double length_scale =
        camera->cam_from_rig.translation.norm() + rig_from_world.translation.norm();
    num_changed += Differs(composed, image.cam_from_world, length_scale);
    image.cam_from_world = composed;
  }
  WarnIf(num_changed, "image poses differ from those of rigs and frames, which were used", model);
  WarnIf(num_kept, "images have no pose by rigs and frames; that of the images file was kept",
         model);
  WarnIf(num_in_two_frames, "images are in two frames; the first one was used", model);
}

}  // namespace limn::colmap_ext
