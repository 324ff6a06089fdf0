// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/epipolar_stretches.h"

#include <algorithm>
#include <functional>

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

// Per vertex the sense in which the curve crosses the epipolar lines, 1 or -1; 0 where it runs
// along them.
std::vector<int> CrossingSenses(const FragmentRays& fragment, const View& primary,
                                const View& second, double min_sine) {
  const Eigen::Vector3d second_center = Inverse(second.cam_from_world).translation;
  const Eigen::Vector3d epipole =
      primary.camera.Calibration() * (primary.cam_from_world * second_center);
  std::vector<int> senses;
  for (size_t i = 0; i < fragment.size(); ++i) {
    const double sine =
        SignedEpipolarSine(epipole, fragment.positions_px[i], fragment.tangents_px[i]);
    senses.push_back(sine >= min_sine ? 1 : -sine >= min_sine ? -1 : 0);
  }
  return senses;
}

// Where to begin: at the first vertex, unless a closed fragment passes it in one direction; then
// where the sense first changes.
int FirstVertex(const FragmentRays& fragment, const std::vector<int>& senses) {
  if (!fragment.closed || senses.front() != senses.back()) return 0;
  const auto change = std::adjacent_find(senses.begin(), senses.end(), std::not_equal_to<>());
  return change == senses.end() ? 0 : static_cast<int>(change - senses.begin()) + 1;
}

}  // namespace

std::vector<VertexStretch> EpipolarStretches(const FragmentRays& fragment, const View& primary,
                                             const View& second, double min_sine,
                                             double min_length_px) {
  const std::vector<int> senses = CrossingSenses(fragment, primary, second, min_sine);
  const int count = static_cast<int>(senses.size());
  const int first = FirstVertex(fragment, senses);
  std::vector<VertexStretch> stretches;
  for (int begin = first; begin < first + count;) {
    const int sense = senses[begin % count];
    int end = begin + 1;
    while (end < first + count && senses[end % count] == sense) ++end;
    const bool is_long = fragment.ArcTo(end - 1) - fragment.ArcTo(begin) >= min_length_px;
    if (sense != 0 && is_long) stretches.push_back({begin, end});
    begin = end;
  }
  return stretches;
}

}  // namespace limn
