// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/alignment.h"

#include <cmath>

#include <Eigen/LU>

#include "limn/util/name_table.h"

namespace limn {

namespace {

constexpr NameTable<UpSource, 4> kUpSources = {{"gravity", "positions", "lines", "cameras"}};
constexpr NameTable<AxesSource, 4> kAxesSources = {{"lines", "positions", "model", "plan"}};
constexpr NameTable<ScaleSource, 3> kScaleSources = {{"none", "lengths", "positions"}};

}  // namespace

const char* SourceName(UpSource source) { return kUpSources.Of(source); }
const char* SourceName(AxesSource source) { return kAxesSources.Of(source); }
const char* SourceName(ScaleSource source) { return kScaleSources.Of(source); }

std::string Validate(const Alignment& alignment) {
  const auto& [scale, rotation, translation] = alignment.world_from_model;
  if (!std::isfinite(scale) || !rotation.allFinite() || !translation.allFinite() ||
      !std::isfinite(alignment.scale_sigma)) {
    return "a number is not finite";
  }
  if (!(scale > 0)) return "the scale is not positive";
  if (!(alignment.scale_sigma >= 0)) return "the standard deviation of the scale is negative";
  if (alignment.scale_sigma > 0 && !alignment.IsMetric()) {
    return "a scale that is not known has no standard deviation";
  }
  const bool is_orthonormal =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-6;
  if (!is_orthonormal || rotation.determinant() < 0) return "the matrix is not a rotation";
  return "";
}

Alignment After(const Similarity3d& file_from_model, Alignment alignment) {
  alignment.world_from_model = alignment.world_from_model * Inverse(file_from_model);
  return alignment;
}

}  // namespace limn
