// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/edge_profile.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int kReachPx = 7;
constexpr int kStepsPerPx = 2;
constexpr int kCenter = kReachPx * kStepsPerPx;
constexpr int kNumPlaces = 2 * kCenter + 1;
constexpr int kHalfAlongPx = 3;
// The steepest place is sought within this many steps of the curve, and used within the second
// number: beyond it is another edge.
constexpr int kSearchSteps = 3;
constexpr int kMaxShiftSteps = 2;
// The step ends where the slope falls below this share of the largest one.
constexpr float kEndOfStep = 0.1F;
constexpr float kMinContrast = 2;
constexpr SideColor kLuminance = {0.299F, 0.587F, 0.114F};

using Profile = std::array<SideColor, kNumPlaces>;

// Whether all four pixels around a place may be used.
bool IsUsable(const Image& image, const Eigen::Vector2d& place) {
  if (!(place.x() >= 0 && place.y() >= 0 && place.x() < image.width - 1 &&
        place.y() < image.height - 1)) {
    return false;
  }
  if (image.mask.empty()) return true;
  const auto x = static_cast<size_t>(place.x());
  const auto y = static_cast<size_t>(place.y());
  const unsigned char* at = image.mask.data() + y * image.width + x;
  return at[0] != 0 && at[1] != 0 && at[image.width] != 0 && at[image.width + 1] != 0;
}

std::optional<Profile> MeanProfile(const Image& image, const Eigen::Vector2d& center,
                                   const Eigen::Vector2d& along) {
  const Eigen::Vector2d across(along.y(), -along.x());
  for (const int u : {-kReachPx, kReachPx}) {
    for (const int v : {-kHalfAlongPx, 0, kHalfAlongPx}) {
      if (!IsUsable(image, center + u * across + v * along)) return std::nullopt;
    }
  }
  Profile profile = {};
  for (int k = 0; k < kNumPlaces; ++k) {
    const Eigen::Vector2d place =
        center + (static_cast<double>(k - kCenter) / kStepsPerPx) * across;
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    for (int v = -kHalfAlongPx; v <= kHalfAlongPx; ++v) color += ColorAt(image, place + v * along);
    color /= 2 * kHalfAlongPx + 1;
    profile[k] = {color[0], color[1], color[2]};
  }
  return profile;
}

// Per place the slope of the luminance, gray levels per px; 0 at both ends.
std::array<float, kNumPlaces> Slopes(const Profile& profile) {
  std::array<float, kNumPlaces> luminance = {};
  for (int k = 0; k < kNumPlaces; ++k) {
    for (int c = 0; c < 3; ++c) luminance[k] += kLuminance[c] * profile[k][c];
  }
  std::array<float, kNumPlaces> slopes = {};
  for (int k = 1; k + 1 < kNumPlaces; ++k) {
    slopes[k] = (luminance[k + 1] - luminance[k - 1]) * kStepsPerPx / 2;
  }
  return slopes;
}

}  // namespace

std::optional<EdgeProfile> MeasureProfile(const Image& image, const Eigen::Vector2d& place_px,
                                          const Eigen::Vector2d& along) {
  const std::optional<Profile> profile = MeanProfile(image, place_px, along);
  if (!profile) return std::nullopt;
  const std::array<float, kNumPlaces> slopes = Slopes(*profile);
  int steepest = kCenter;
  for (int k = kCenter - kSearchSteps; k <= kCenter + kSearchSteps; ++k) {
    if (std::abs(slopes[k]) > std::abs(slopes[steepest])) steepest = k;
  }
  if (std::abs(steepest - kCenter) > kMaxShiftSteps) return std::nullopt;
  const float slope = slopes[steepest];
  const auto rises = [&](int k) { return slopes[k] * slope > kEndOfStep * slope * slope; };
  int first = steepest;
  int last = steepest;
  while (first > 0 && rises(first)) --first;
  while (last + 1 < kNumPlaces && rises(last)) ++last;
  EdgeProfile result;
  result.right = (*profile)[first];
  result.left = (*profile)[last];
  for (int c = 0; c < 3; ++c) {
    result.contrast += kLuminance[c] * (result.left[c] - result.right[c]);
  }
  result.contrast = std::abs(result.contrast);
  if (!(result.contrast >= kMinContrast)) return std::nullopt;
  result.width_px = result.contrast / (std::abs(slope) * static_cast<float>(std::sqrt(2 * M_PI)));
  return result;
}

}  // namespace limn
