// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/regularities.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

template <typename Items>
bool HasIndex(const Items& items, int index) {
  return index >= 0 && index < static_cast<int>(items.size());
}

bool IsUnit(const Eigen::Vector3d& vector) { return std::abs(vector.norm() - 1) < 1e-6; }

std::string ProblemOf(const CommonDirection& of, const Regularities& all) {
  if (!IsUnit(of.direction)) return "a direction is not a unit vector";
  const bool are_known = std::all_of(of.orthogonal_to.begin(), of.orthogonal_to.end(),
                                     [&](int other) { return HasIndex(all.directions, other); });
  return are_known ? "" : "a direction is orthogonal to one that there is not";
}

std::string ProblemOf(const CommonPlane& of, const Regularities& all) {
  if (!IsUnit(of.normal) || !std::isfinite(of.offset)) return "a plane has no normal or no offset";
  const bool is_known = of.normal_direction == -1 || HasIndex(all.directions, of.normal_direction);
  return is_known ? "" : "the normal of a plane is a direction that there is not";
}

}  // namespace

std::string Validate(const Regularities& regularities) {
  std::string problem;
  for (const CommonDirection& of : regularities.directions) {
    if (problem.empty()) problem = ProblemOf(of, regularities);
  }
  for (const CommonPlane& of : regularities.planes) {
    if (problem.empty()) problem = ProblemOf(of, regularities);
  }
  for (const double radius : regularities.radii) {
    if (problem.empty() && !(radius > 0 && std::isfinite(radius))) {
      problem = "a radius is not positive";
    }
  }
  for (const CommonAxis& of : regularities.axes) {
    if (problem.empty() && !(IsUnit(of.direction) && of.point.allFinite())) {
      problem = "an axis has no direction or no point";
    }
  }
  return problem;
}

std::string Validate(const LinkRegularity& link, const Regularities& regularities) {
  const bool is_known =
      (link.direction == -1 || HasIndex(regularities.directions, link.direction)) &&
      (link.radius == -1 || HasIndex(regularities.radii, link.radius)) &&
      (link.axis == -1 || HasIndex(regularities.axes, link.axis)) &&
      std::all_of(link.planes.begin(), link.planes.end(),
                  [&](int plane) { return HasIndex(regularities.planes, plane); });
  return is_known ? "" : "it follows a regularity that there is not";
}

Regularities Transformed(Regularities regularities, const Similarity3d& similarity) {
  const auto& [scale, rotation, translation] = similarity;
  for (CommonDirection& of : regularities.directions) of.direction = rotation * of.direction;
  for (CommonPlane& of : regularities.planes) {
    of.normal = rotation * of.normal;
    of.offset = scale * of.offset + of.normal.dot(translation);
  }
  for (double& radius : regularities.radii) radius *= scale;
  for (CommonAxis& of : regularities.axes) {
    of.point = scale * (rotation * of.point) + translation;
    of.direction = rotation * of.direction;
  }
  return regularities;
}

}  // namespace limn
