#include "limn/model/alignment.h"

#include <cmath>

#include <Eigen/LU>

namespace limn {

const char* SourceName(UpSource source) {
  switch (source) {
    case UpSource::kGravity:
      return "gravity";
    case UpSource::kPositions:
      return "positions";
    case UpSource::kLines:
      return "lines";
    case UpSource::kCameras:
      return "cameras";
  }
  return "";
}

const char* SourceName(AxesSource source) {
  switch (source) {
    case AxesSource::kLines:
      return "lines";
    case AxesSource::kPositions:
      return "positions";
    case AxesSource::kModel:
      return "model";
  }
  return "";
}

const char* SourceName(ScaleSource source) {
  switch (source) {
    case ScaleSource::kNone:
      return "none";
    case ScaleSource::kLengths:
      return "lengths";
    case ScaleSource::kPositions:
      return "positions";
  }
  return "";
}

std::string Validate(const Alignment& alignment) {
  const auto& [scale, rotation, translation] = alignment.world_from_model;
  if (!std::isfinite(scale) || !rotation.allFinite() || !translation.allFinite()) {
    return "a number is not finite";
  }
  if (!(scale > 0)) return "the scale is not positive";
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
