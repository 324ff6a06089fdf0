// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/dense/link_classes.h"

namespace limn {

// A sample of the drawing as a point of a cloud.
struct CurvePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();
  double footprint = 0;
  // Unit normals of the faces that meet here, left and right; zero = not known.
  std::array<Eigen::Vector3d, 2> normals = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  // The supporting views of its link that see it, ascending; all supporting views if the dense
  // results cannot tell.
  std::vector<ViewId> views;
  DenseClass sample_class = DenseClass::kUnknown;
  LinkId link = -1;
  std::array<uint8_t, 3> color = {};  // set by the caller, who has the photographs

  bool HasNormal() const { return normals[0].norm() > 0 || normals[1].norm() > 0; }
  // Direction to the outside: the mean of the known normals, else the direction to the mean camera,
  // across the curve.
  Eigen::Vector3d Outward(const std::vector<View>& all_views) const;
};

// Points for the samples of all links that are not behind the surface, where any view sees them.
// Two normals that differ by only a few degrees become one, since the face continues.
std::vector<CurvePoint> MakeCurvePoints(const DrawingGraph& graph, const DrawingSamples& samples,
                                        const std::vector<SampleSupport>& support,
                                        const DenseClasses& classes);

}  // namespace limn
