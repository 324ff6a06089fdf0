// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/side_colors.h"

namespace limn {
namespace {

// Beyond the blur of the edge.
constexpr double kSideDistancePx = 2.5;

}  // namespace

std::vector<SideColors> MeasureSideColors(const std::vector<Edgel>& edgels, const Image* image) {
  std::vector<SideColors> colors(edgels.size(), {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()});
  if (!image) return colors;
  for (size_t i = 0; i < edgels.size(); ++i) {
    const Eigen::Vector2d across = kSideDistancePx * edgels[i].Normal();
    colors[i] = {ColorAt(*image, image->FromView(edgels[i].position_px - across)),
                 ColorAt(*image, image->FromView(edgels[i].position_px + across))};
  }
  return colors;
}

}  // namespace limn
