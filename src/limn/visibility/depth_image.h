// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// Depths along the optical axis on a grid over a view's virtual image.
struct DepthImage {
  int width = 0;
  int height = 0;
  // The depth pixel (column, row) stands for the place origin_px + cell_px * (column, row) of the
  // virtual image. A depth map of COLMAP's has its origin at (-0.5, -0.5).
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d cell_px = Eigen::Vector2d::Ones();
  // Row-major: z in the camera frame, 0 = nothing there, or unknown.
  std::vector<float> depth;
  // Unit normals in the world, facing the view; zero = unknown. Empty: all unknown.
  std::vector<Eigen::Vector3f> normal_in_world;

  bool Contains(int column, int row) const {
    return column >= 0 && column < width && row >= 0 && row < height;
  }
  size_t Index(int column, int row) const { return static_cast<size_t>(row) * width + column; }
  float At(int column, int row) const { return depth[Index(column, row)]; }
  // 0 outside.
  float DepthOr0(int column, int row) const { return Contains(column, row) ? At(column, row) : 0; }
  Eigen::Vector2d FromVirtual(const Eigen::Vector2d& virtual_px) const {
    return (virtual_px - origin_px).cwiseQuotient(cell_px);
  }
  // Column and row of the nearest depth pixel, which may be outside.
  Eigen::Vector2i CellAt(const Eigen::Vector2d& virtual_px) const {
    return FromVirtual(virtual_px).array().round().cast<int>();
  }
  Eigen::Vector2d PixelOf(int column, int row) const {
    return origin_px + cell_px.cwiseProduct(Eigen::Vector2d(column, row));
  }
};

// An empty depth image over the region of a view, with `scale` depth pixels per virtual pixel.
// Precondition: scale > 0.
DepthImage MakeDepthImage(const View& view, double scale);

// Whether a position in the virtual image, at depth z, is farther by more than `tolerance` than all
// of the (up to four) depth pixels around it: the farthest counts, so that edges at the border of a
// surface are not behind it. False if one of them is unknown. Constant time.
bool IsBehind(const DepthImage& depth, const Eigen::Vector2d& virtual_px, double z,
              double tolerance);

// Whether the view contains a point and the depth image does not hide it: not behind (IsBehind) by
// more than `tolerance_px` pixel footprints. Constant time.
bool IsVisible(const View& view, const DepthImage& depth, const Eigen::Vector3d& point_in_world,
               double tolerance_px);

// The normal of the surface at a depth pixel, in the world, facing the view: the stored one, else
// from the four neighboring depths if there is no step between them. Nothing if unknown.
std::optional<Eigen::Vector3d> NormalAt(const View& view, const DepthImage& image, int column,
                                        int row);

}  // namespace limn
