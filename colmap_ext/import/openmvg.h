// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A sfm_data.json of openMVG: views (local_path and filename, below root_path), intrinsics,
// extrinsics (rotation, row by row, world to camera, and camera center) and structure. Views
// without a pose were not reconstructed and are left out.
//
//   pinhole            SIMPLE_PINHOLE
//   pinhole_radial_k1  SIMPLE_RADIAL
//   pinhole_radial_k3  PINHOLE, OPENCV or FULL_OPENCV (brown_lens.h), as is
//   pinhole_brown_t2   ...
//   fisheye            OPENCV_FISHEYE
//
// Panoramas (spherical) are refused. Points keep positions and measurements; they have no colors.
//
// Pixel centers: integer: openMVG looks up a pixel's color, and finds features, with its center at
// whole numbers. Its export to COLMAP copies positions without moving them by half a pixel.

// Whether it is such a file, or a folder with one.
bool HoldsOpenmvg(const std::filesystem::path& path);

// Throws IoError with the view, pose, camera or point, counted from 0: missing members, wrong
// types, unknown cameras, a matrix that is no rotation, a missing image or one of another aspect.
ImportedScene ReadOpenmvg(const ImportInput& input);

}  // namespace limn::colmap_ext
