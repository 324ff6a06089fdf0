// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/similarity3.h"

namespace limn {

// What links of a drawing have exactly in common (limn/regularity/). Links refer to it by index.
// Directions and normals are unit vectors, positions and lengths in world units.

// Of straight links that are parallel.
struct CommonDirection {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  // Indices of directions that are perpendicular to it, ascending.
  std::vector<int> orthogonal_to;
};

// Of lines and arcs in one plane: normal . x = offset.
struct CommonPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  int normal_direction = -1;  // index of the direction that is the normal; -1: none
};

// Of arcs and circles around one axis.
struct CommonAxis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

struct Regularities {
  std::vector<CommonDirection> directions;
  std::vector<CommonPlane> planes;
  std::vector<double> radii;
  std::vector<CommonAxis> axes;

  bool IsEmpty() const {
    return directions.empty() && planes.empty() && radii.empty() && axes.empty();
  }
};

// The regularities that a link follows; -1: none of that kind.
struct LinkRegularity {
  int direction = -1;
  int radius = -1;
  int axis = -1;
  std::vector<int> planes;  // ascending
};

// What is wrong with them; empty if they are valid: indices out of range, numbers that are not
// finite, vectors that are not unit vectors, radii that are not positive.
std::string Validate(const Regularities& regularities);
std::string Validate(const LinkRegularity& link, const Regularities& regularities);

// Under a change of coordinates.
Regularities Transformed(Regularities regularities, const Similarity3d& similarity);

}  // namespace limn
