#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "colmap_ext/workspace/camera_model.h"
#include "colmap_ext/workspace/image_reader.h"
#include "colmap_ext/workspace/model_builder.h"
#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

// Matrices of cameras, as text files hold them, to what a COLMAP model holds. All throw IoError via
// `place`.

// The PINHOLE camera of a calibration matrix K (upper triangular, any scale but zero) for images of
// this size. Skew that moves nothing in the image by more than 0.05 px is dropped, more is refused,
// for COLMAP has no camera with skew; so are matrices that are not finite or not of this form.
Camera CameraFromCalibration(const Eigen::Matrix3d& calibration, const ImageSize& size,
                             const Place& place);

// The rotation nearest to a matrix whose columns are orthogonal and of unit length within 1e-3
// (files with few digits); anything else, mirrors too, is refused.
Eigen::Quaterniond RotationFromMatrix(const Eigen::Matrix3d& matrix, const Place& place);

// P = scale * K [R | t] with a rotation R and positive focal lengths in K, whose last element is 1.
struct CalibratedPose {
  Eigen::Matrix3d calibration;
  Rigid3d cam_from_world;
};

// Any scale of P, negative ones too, gives the same camera. (P and -P project alike; a matrix that
// was made for a camera looking backwards cannot be told from one looking forwards.) Refuses
// matrices that are not finite, and singular ones: affine cameras, ranks below three.
CalibratedPose DecomposeProjection(const Eigen::Matrix<double, 3, 4>& projection,
                                   const Place& place);

}  // namespace limn::colmap_ext
