// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/triangle_mesh.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// A rectangle in a plane that is viewed along its normal.
struct OrthographicFrame {
  // Unit rows: right, down, forward (away from the eye), as axes of the world.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // The rectangle in (right, down) coordinates, world units.
  Eigen::Vector2d min = Eigen::Vector2d::Zero();
  Eigen::Vector2d max = Eigen::Vector2d::Zero();
  // Edge length of a depth pixel, world units.
  double cell = 1;
};

// Depths in parallel projection: "virtual pixels" of `image` are world units along right and down,
// depths are along forward, from `front` on.
struct OrthographicDepth {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double front = 0;
  DepthImage image;
};

// Of a mesh, like RenderDepth. Time: triangles plus depth pixels covered. Throws InputError if
// these are too many (RasterWork), as the next.
OrthographicDepth RenderOrthographicDepth(const TriangleMesh& mesh, const OrthographicFrame& frame);

// Of a cloud whose points are discs of `radius`, world units, like SplatDepth. PointSpacing, or a
// little more, is a good radius.
OrthographicDepth SplatOrthographicDepth(const std::vector<Eigen::Vector3d>& points,
                                         const OrthographicFrame& frame, double radius);

// Like IsBehind for depth images; `tolerance` in world units.
bool IsBehind(const OrthographicDepth& depth, const Eigen::Vector3d& point_in_world,
              double tolerance);

}  // namespace limn
