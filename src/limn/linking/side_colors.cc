#include "limn/linking/side_colors.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Beyond the blur of the edge.
constexpr double kSideDistancePx = 2.5;

Eigen::Vector3f ColorAt(const Image& image, const Eigen::Vector2d& place) {
  const auto x = std::clamp<long>(std::lround(place.x()), 0, image.width - 1);
  const auto y = std::clamp<long>(std::lround(place.y()), 0, image.height - 1);
  const float* at = image.data.data() + (y * image.width + x) * image.channels;
  return image.channels == 3 ? Eigen::Vector3f(at[0], at[1], at[2])
                             : Eigen::Vector3f::Constant(at[0]);
}

}  // namespace

std::vector<SideColors> MeasureSideColors(const std::vector<Edgel>& edgels, const Image* image) {
  std::vector<SideColors> colors(edgels.size(), {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()});
  if (!image) return colors;
  for (size_t i = 0; i < edgels.size(); ++i) {
    const Eigen::Vector2d across = kSideDistancePx * edgels[i].Normal();
    colors[i] = {ColorAt(*image, edgels[i].position_px - across),
                 ColorAt(*image, edgels[i].position_px + across)};
  }
  return colors;
}

}  // namespace limn
