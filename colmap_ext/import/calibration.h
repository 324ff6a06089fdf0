#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "colmap_ext/model/camera_model.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/workspace/image_reader.h"

namespace limn::colmap_ext {

// Matrices of cameras, as text files hold them, to what a COLMAP model holds. All throw IoError via
// `place`.

// The PINHOLE camera of a calibration matrix K (upper triangular, any scale but zero) for images of
// this size. Skew that moves nothing in the image by more than 0.05 px is dropped, more is refused,
// for COLMAP has no camera with skew; so are matrices that are not finite or not of this form.
Camera CameraFromCalibration(const Eigen::Matrix3d& calibration, const ImageSize& size,
                             const FilePlace& place);

// The rotation nearest to a matrix whose columns are orthogonal and of unit length within 1e-3
// (files with few digits); anything else, mirrors too, is refused.
Eigen::Quaterniond RotationFromMatrix(const Eigen::Matrix3d& matrix, const FilePlace& place);

}  // namespace limn::colmap_ext
