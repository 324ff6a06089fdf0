// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "colmap_ext/model/camera_model.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/workspace/image_reader.h"

namespace limn::colmap_ext {

// Converts camera matrices as stored in text files to what a COLMAP model stores. All throw IoError
// via `place`.

// The PINHOLE camera of a calibration matrix K (upper triangular, any scale but zero) for images of
// this size. Skew that moves no pixel by more than 0.05 px is dropped; more is an error, since
// COLMAP has no camera model with skew, as are matrices that are not finite or not of this form.
Camera CameraFromCalibration(const Eigen::Matrix3d& calibration, const ImageSize& size,
                             const FilePlace& place);

// The rotation nearest to a matrix whose columns are orthogonal and of unit length within 1e-3
// (files with few digits). Anything else, reflections included, is an error.
Eigen::Quaterniond RotationFromMatrix(const Eigen::Matrix3d& matrix, const FilePlace& place);

}  // namespace limn::colmap_ext
