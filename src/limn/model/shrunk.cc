// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/shrunk.h"

#include <utility>

namespace limn {
namespace {

// Sizes that are whole numbers but for it keep their last pixel.
constexpr double kRounding = 1e-6;

class ShrunkLens : public LensMap {
 public:
  ShrunkLens(std::shared_ptr<const LensMap> lens, double factor)
      : lens_(std::move(lens)), factor_(factor) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const override {
    const auto px = lens_->VirtualFromStored(GrownPx(stored_px, factor_));
    return px ? std::optional(ShrunkPx(*px, factor_)) : std::nullopt;
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    const auto px = lens_->StoredFromVirtual(GrownPx(virtual_px, factor_));
    return px ? std::optional(ShrunkPx(*px, factor_)) : std::nullopt;
  }

 private:
  std::shared_ptr<const LensMap> lens_;
  double factor_;
};

}  // namespace

Image Shrunk(const Image& image, int factor) {
  if (factor == 1) return image;
  Image shrunk;
  shrunk.width = image.width / factor;
  shrunk.height = image.height / factor;
  shrunk.channels = image.channels;
  const size_t channels = image.channels;
  shrunk.data.assign(static_cast<size_t>(shrunk.width) * shrunk.height * channels, 0);
  if (!image.mask.empty()) {
    shrunk.mask.assign(static_cast<size_t>(shrunk.width) * shrunk.height, 255);
  }
  const float share = 1.0F / static_cast<float>(factor * factor);
  for (int y = 0; y < shrunk.height * factor; ++y) {
    for (int x = 0; x < shrunk.width * factor; ++x) {
      const size_t from = static_cast<size_t>(y) * image.width + x;
      const size_t to = static_cast<size_t>(y / factor) * shrunk.width + x / factor;
      for (size_t c = 0; c < channels; ++c) {
        shrunk.data[to * channels + c] += share * image.data[from * channels + c];
      }
      if (!image.mask.empty() && image.mask[from] == 0) shrunk.mask[to] = 0;
    }
  }
  return shrunk;
}

View Shrunk(const View& view, double factor) {
  View shrunk = view;
  shrunk.calibration = nullptr;
  shrunk.scale /= factor;
  if (factor == 1) return shrunk;
  PinholeCamera& camera = shrunk.camera;
  camera.fx /= factor;
  camera.fy /= factor;
  const Eigen::Vector2d center = ShrunkPx({camera.cx, camera.cy}, factor);
  camera.cx = center.x();
  camera.cy = center.y();
  camera.width = static_cast<int>(camera.width / factor + kRounding);
  camera.height = static_cast<int>(camera.height / factor + kRounding);
  ImageRegion& region = shrunk.region;
  region.min_px = ShrunkPx(region.min_px, factor);
  region.max_px = ShrunkPx(region.max_px, factor);
  region.cell_px /= factor;
  if (shrunk.lens) shrunk.lens = std::make_shared<ShrunkLens>(std::move(shrunk.lens), factor);
  return shrunk;
}

}  // namespace limn
