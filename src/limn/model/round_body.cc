// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/round_body.h"

#include <cmath>

#include "limn/util/name_table.h"

namespace limn {
namespace {

constexpr NameTable<RoundShape, kNumRoundShapes> kRoundShapes = {{"cylinder", "cone", "sphere"}};

}  // namespace

const char* RoundShapeName(RoundShape shape) { return kRoundShapes.Of(shape); }

std::optional<RoundShape> RoundShapeNamed(const std::string& name) {
  return kRoundShapes.Find(name);
}

RoundBody Transformed(RoundBody body, const Similarity3d& similarity) {
  body.start = similarity * body.start;
  body.end = similarity * body.end;
  body.start_radius *= similarity.scale;
  body.end_radius *= similarity.scale;
  body.radius_sigma *= similarity.scale;
  return body;
}

std::string Validate(const RoundBody& body) {
  const bool is_finite = body.start.allFinite() && body.end.allFinite() &&
                         std::isfinite(body.start_radius) && std::isfinite(body.end_radius) &&
                         std::isfinite(body.radius_sigma) && std::isfinite(body.rms_px);
  if (!is_finite) return "its body is not finite";
  if (!(body.start_radius >= 0 && body.end_radius >= 0 && body.MeanRadius() > 0) ||
      !(body.radius_sigma >= 0 && body.rms_px >= 0)) {
    return "a number of its body is below 0, or its radius is 0";
  }
  if (body.shape != RoundShape::kCone && body.start_radius != body.end_radius) {
    return "a body with two radii that is no cone";
  }
  if ((body.shape == RoundShape::kSphere) != (body.start == body.end)) {
    return "a body has no axis, or is a sphere with one";
  }
  return "";
}

}  // namespace limn
