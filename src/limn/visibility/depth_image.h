#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// How far a view sees, on a grid over its virtual image.
struct DepthImage {
  int width = 0;
  int height = 0;
  // Depth pixels per virtual pixel.
  double scale = 1;
  // Where the centre of depth pixel (0, 0) is in the virtual image. A depth map of COLMAP's has it
  // at (-0.5, -0.5).
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();
  // Rows in order: z in the camera frame, 0 = nothing there.
  std::vector<float> depth;

  float At(int column, int row) const { return depth[static_cast<size_t>(row) * width + column]; }
  Eigen::Vector2d FromVirtual(const Eigen::Vector2d& virtual_px) const {
    return (virtual_px - origin_px) * scale;
  }
};

// An empty depth image over the region of a view. Precondition: scale > 0.
DepthImage MakeDepthImage(const View& view, double scale);

// Whether the view contains a point and sees it in front of what the depth image holds: farther by
// no more than `tolerance_px` pixel footprints than one of the (up to four) depth pixels around it.
// Of these the farthest decides, so that edges at the border of a surface count as visible.
// Constant time.
bool IsVisible(const View& view, const DepthImage& depth, const Eigen::Vector3d& point_in_world,
               double tolerance_px);

}  // namespace limn
