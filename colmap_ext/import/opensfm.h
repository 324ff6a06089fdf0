// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A reconstruction.json of OpenSfM or OpenDroneMap: a list of reconstructions, each with cameras,
// shots (by image name) and points. A shot's rotation is an angle-axis vector (rad) and with its
// translation takes the world to the camera (x right, y down, z forward). Focal lengths and
// principal points are relative to the longer side of the image, the latter from its center.
//
//   perspective                  RADIAL (SIMPLE_PINHOLE where k1 and k2 are zero)
//   simple_radial, radial, brown PINHOLE, OPENCV or FULL_OPENCV (brown_lens.h)
//   fisheye, fisheye_opencv      OPENCV_FISHEYE
//
// Others (fisheye62, fisheye624, dual, panoramas) are refused. Of several reconstructions the one
// with the most shots is read, or that of model_index. Points are read if tracks.csv, which tells
// their images, is beside the file.
//
// Pixel centers: half, as the center of the image is w/2 from its border.

// Whether it is such a file, or a folder with one.
bool HoldsOpensfm(const std::filesystem::path& path);

// Throws IoError with the shot, counted from 0: missing members, wrong types, unknown cameras, a
// missing image or one of another aspect.
ImportedScene ReadOpensfm(const ImportInput& input);

}  // namespace limn::colmap_ext
