// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "limn/geometry/similarity3.h"

namespace limn {

enum class RoundShape : uint8_t { kCylinder, kCone, kSphere };
constexpr int kNumRoundShapes = 3;

// "cylinder", "cone", "sphere".
const char* RoundShapeName(RoundShape shape);
// Nothing if there is no such shape.
std::optional<RoundShape> RoundShapeNamed(const std::string& name);

// A smooth body of which links are outlines, world units.
struct RoundBody {
  RoundShape shape = RoundShape::kCylinder;
  // The part of the axis along which outlines were seen; of a sphere, both are the center.
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  // At start and end; they differ for cones only.
  double start_radius = 0;
  double end_radius = 0;
  double radius_sigma = 0;  // standard deviation of the mean radius
  double rms_px = 0;        // of the edgels of its outlines

  double MeanRadius() const { return 0.5 * (start_radius + end_radius); }

  bool operator==(const RoundBody&) const = default;
};

RoundBody Transformed(RoundBody body, const Similarity3d& similarity);

// What is wrong with it; empty if nothing is: numbers finite, radii that fit the shape and are not
// below 0, an axis of some length unless it is a sphere.
std::string Validate(const RoundBody& body);

}  // namespace limn
