#include "limn/refinement/camera_corrections.h"

#include <cmath>

namespace limn {

CameraCorrections::CameraCorrections(const std::vector<View>& views) : motion(views.size()) {
  for (const View& view : views) log_focal[view.camera_index] = 0;
}

PosedCamera Corrected(const View& view, const double* motion, double log_focal) {
  const Eigen::Map<const Eigen::Vector3d> turn(motion);
  const Rigid3d change = {Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())),
                          Eigen::Map<const Eigen::Vector3d>(motion + 3)};
  PosedCamera corrected = {view.camera, change * view.cam_from_world};
  const double factor = std::exp(log_focal);
  corrected.camera.fx *= factor;
  corrected.camera.fy *= factor;
  return corrected;
}

std::vector<View> Corrected(const std::vector<View>& views, const CameraCorrections& corrections) {
  std::vector<View> corrected = views;
  for (size_t v = 0; v < views.size(); ++v) {
    const PosedCamera posed = Corrected(views[v], corrections.motion[v].data(),
                                        corrections.log_focal.at(views[v].camera_index));
    corrected[v].camera = posed.camera;
    corrected[v].cam_from_world = posed.cam_from_world;
    corrected[v].cam_from_world.rotation.normalize();
  }
  return corrected;
}

}  // namespace limn
