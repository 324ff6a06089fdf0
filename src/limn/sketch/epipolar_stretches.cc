#include "limn/sketch/epipolar_stretches.h"

namespace limn {
namespace {

// Sine of the angle from the epipolar line to the tangent: its sign is the sense in which the curve
// crosses the lines.
double SignedEpipolarSine(const Eigen::Vector3d& epipole, const Eigen::Vector2d& pixel,
                          const Eigen::Vector2d& tangent) {
  const Eigen::Vector2d line = epipole.head<2>() - pixel * epipole.z();
  const double norm = line.norm();
  return norm > 0 ? (line.x() * tangent.y() - line.y() * tangent.x()) / norm : 0;
}

}  // namespace

std::vector<VertexStretch> EpipolarStretches(const FragmentRays& fragment, const View& primary,
                                             const View& second, double min_sine,
                                             double min_length_px) {
  const Eigen::Vector3d second_center = Inverse(second.cam_from_world).translation;
  const Eigen::Vector3d epipole =
      primary.camera.Calibration() * (primary.cam_from_world * second_center);
  const int count = static_cast<int>(fragment.size());
  std::vector<VertexStretch> stretches;
  int begin = 0;
  int sense = 0;  // of the stretch since begin; 0 = none
  const auto finish = [&](int end) {
    if (sense == 0) return;
    if (fragment.arc_px[end - 1] - fragment.arc_px[begin] >= min_length_px) {
      stretches.push_back({begin, end});
    }
  };
  for (int i = 0; i < count; ++i) {
    const double sine =
        SignedEpipolarSine(epipole, fragment.positions_px[i], fragment.tangents_px[i]);
    const int here = sine >= min_sine ? 1 : -sine >= min_sine ? -1 : 0;
    if (here == sense) continue;
    finish(i);
    begin = i;
    sense = here;
  }
  finish(count);
  return stretches;
}

}  // namespace limn
