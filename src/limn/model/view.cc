// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double kRegionCellPx = 4;

bool StoredPixelIsValid(const Eigen::Vector2d& stored, const PinholeCamera& camera,
                        const std::vector<unsigned char>& mask, double margin_px) {
  if (!(stored.x() >= margin_px && stored.x() <= camera.width - 1 - margin_px &&
        stored.y() >= margin_px && stored.y() <= camera.height - 1 - margin_px)) {
    return false;
  }
  if (mask.empty()) return true;
  const int x = static_cast<int>(std::lround(stored.x()));
  const int y = static_cast<int>(std::lround(stored.y()));
  return mask[static_cast<size_t>(y) * camera.width + x] != 0;
}

// Box of the virtual positions of the stored image's pixels, sampled over the whole image: with
// strong fisheye lenses only the inner part maps at all.
void VirtualBox(const PinholeCamera& camera, const LensMap& lens, ImageRegion* region) {
  region->min_px.setConstant(std::numeric_limits<double>::infinity());
  region->max_px = -region->min_px;
  const int step = 4;
  for (int y = 0; y < camera.height + step - 1; y += step) {
    for (int x = 0; x < camera.width + step - 1; x += step) {
      const Eigen::Vector2d stored(std::min(x, camera.width - 1), std::min(y, camera.height - 1));
      const auto pixel = lens.VirtualFromStored(stored);
      if (!pixel) continue;
      region->min_px = region->min_px.cwiseMin(*pixel);
      region->max_px = region->max_px.cwiseMax(*pixel);
    }
  }
  if (!(region->min_px.array() <= region->max_px.array()).all()) {
    region->min_px = region->max_px = Eigen::Vector2d::Zero();
  }
}

void AddCells(const LensMap* lens, const std::function<bool(const Eigen::Vector2d&)>& is_valid,
              ImageRegion* region) {
  const Eigen::Vector2d extent = region->max_px - region->min_px;
  region->cell_px = kRegionCellPx;
  region->cols = std::max(1, static_cast<int>(std::ceil(extent.x() / kRegionCellPx)));
  region->rows = std::max(1, static_cast<int>(std::ceil(extent.y() / kRegionCellPx)));
  region->valid.assign(static_cast<size_t>(region->rows) * region->cols, 0);
  for (int row = 0; row < region->rows; ++row) {
    for (int col = 0; col < region->cols; ++col) {
      const Eigen::Vector2d pixel =
          region->min_px + kRegionCellPx * Eigen::Vector2d(col + 0.5, row + 0.5);
      const auto stored = lens ? lens->StoredFromVirtual(pixel) : std::optional(pixel);
      region->valid[static_cast<size_t>(row) * region->cols + col] = stored && is_valid(*stored);
    }
  }
}

}  // namespace

bool ImageRegion::CellIsValid(const Eigen::Vector2d& pixel) const {
  const int col = std::min(static_cast<int>((pixel.x() - min_px.x()) / cell_px), cols - 1);
  const int row = std::min(static_cast<int>((pixel.y() - min_px.y()) / cell_px), rows - 1);
  return valid[static_cast<size_t>(row) * cols + col] != 0;
}

Eigen::Vector3d View::CenterInWorld() const { return Inverse(cam_from_world).translation; }

std::optional<Eigen::Vector2d> View::Project(const Eigen::Vector3d& point_in_world) const {
  const Eigen::Vector3d point_in_cam = cam_from_world * point_in_world;
  if (!(point_in_cam.z() > 0)) return std::nullopt;
  const Eigen::Vector2d pixel = camera.Project(point_in_cam);
  if (!region.Contains(pixel)) return std::nullopt;
  return pixel;
}

std::optional<Eigen::Vector2d> View::StoredFromVirtual(const Eigen::Vector2d& virtual_px) const {
  if (!lens) return virtual_px;
  return lens->StoredFromVirtual(virtual_px);
}

std::optional<Eigen::Vector2d> View::VirtualFromStored(const Eigen::Vector2d& stored_px) const {
  if (!lens) return stored_px;
  return lens->VirtualFromStored(stored_px);
}

void SetOptics(const Optics& optics, View* view) {
  view->camera = optics.camera;
  view->lens = optics.lens;
  view->calibration = optics.calibration;
}

ImageRegion MakeImageRegion(const PinholeCamera& camera, const LensMap* lens,
                            const std::function<bool(const Eigen::Vector2d&)>& is_valid) {
  ImageRegion region;
  region.max_px = {camera.width - 1, camera.height - 1};
  if (lens) VirtualBox(camera, *lens, &region);
  AddCells(lens, is_valid, &region);
  return region;
}

ImageRegion MakeImageRegion(const PinholeCamera& camera, const LensMap* lens,
                            const std::vector<unsigned char>& mask, double margin_px) {
  ImageRegion region;
  if (!lens) {
    region.min_px.setConstant(margin_px);
    region.max_px = {camera.width - 1 - margin_px, camera.height - 1 - margin_px};
    if (mask.empty()) return region;
  } else {
    VirtualBox(camera, *lens, &region);
  }
  AddCells(
      lens,
      [&](const Eigen::Vector2d& stored) {
        return StoredPixelIsValid(stored, camera, mask, margin_px);
      },
      &region);
  return region;
}

}  // namespace limn
