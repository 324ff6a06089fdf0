// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limn/geometry/pinhole_camera.h"
#include "limn/geometry/rigid3.h"
#include "limn/model/calibration.h"
#include "limn/model/lens_map.h"

namespace limn {

// Index of a view in the run's list of views (sorted by name).
using ViewId = int32_t;

// Which pixels of the virtual pinhole image the photograph covers: a box, and inside it, for lenses
// and masks, a coarse grid of cells.
struct ImageRegion {
  Eigen::Vector2d min_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d max_px = Eigen::Vector2d::Zero();
  // Edge length of a cell; 0 if there are no cells, only the box.
  double cell_px = 0;
  int cols = 0;
  int rows = 0;
  std::vector<uint8_t> valid;  // rows x cols, row-major, nonzero = covered

  bool Contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= min_px.x() && pixel.x() <= max_px.x() && pixel.y() >= min_px.y() &&
           pixel.y() <= max_px.y() && (cell_px == 0 || CellIsValid(pixel));
  }
  // Precondition: the pixel is inside the box, and there are cells.
  bool CellIsValid(const Eigen::Vector2d& pixel) const;
};

// A photograph: a pinhole camera with a pose. Immutable once made.
struct View {
  // Index of the image in the COLMAP model file, for .vis and PMVS numbering.
  int model_index = 0;
  // As in the model: relative to the image folder, with subfolders.
  std::string name;
  // Views with the same number were taken by one camera and share its optics.
  int camera_index = 0;
  PinholeCamera camera;
  // Pixels of the camera per pixel of the photograph (Image::scale), the same in both directions
  // but for the rounding of its size.
  double scale = 1;
  Rigid3d cam_from_world;
  ImageRegion region;
  // Null if the stored image is a pinhole image.
  std::shared_ptr<const LensMap> lens;
  // Null if the optics are not to change.
  std::shared_ptr<const Calibration> calibration;

  Eigen::Vector3d CenterInWorld() const;
  // Nothing if the point is behind the camera or outside the region.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& point_in_world) const;
  // From the virtual image to the image as stored; nothing where the lens cannot map.
  std::optional<Eigen::Vector2d> StoredFromVirtual(const Eigen::Vector2d& virtual_px) const;
  // And back; nothing where the lens cannot map.
  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored_px) const;
};

// Camera, lens and calibration of the view; its region stays.
void SetOptics(const Optics& optics, View* view);

// The region of a photograph: its rectangle without a margin, without what the mask excludes
// (stored pixels, one byte each, 0 = do not use; empty = none), without what the lens cannot map.
ImageRegion MakeImageRegion(const PinholeCamera& camera, const LensMap* lens,
                            const std::vector<unsigned char>& mask, double margin_px);

// The region of what `is_valid` of the pixels as stored.
ImageRegion MakeImageRegion(const PinholeCamera& camera, const LensMap* lens,
                            const std::function<bool(const Eigen::Vector2d&)>& is_valid);

}  // namespace limn
