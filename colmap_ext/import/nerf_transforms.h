// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A transforms.json of NeRF, instant-ngp or nerfstudio. Per frame: file_path, relative to the file
// (a name without extension means .png), and transform_matrix, world-from-camera in OpenGL's camera
// axes (x right, y up, z backwards). At the top or per frame: focal lengths fl_x and fl_y, or
// camera_angle_x and camera_angle_y (full angles, rad; without one for y, pixels are square); cx
// and cy (default: the center of the image); w and h; mask_path per frame, relative like file_path;
// k1 k2 k3 k4 p1 p2; camera_model, is_fisheye.
//
// Cameras become PINHOLE without distortion, OPENCV with it, FULL_OPENCV if k3 or k4 is given,
// OPENCV_FISHEYE if the file says so (brown_lens.h). Points in other files (ply_file_path) are not
// read.
//
// Pixel centers: half; these tools copy cx and cy from COLMAP.

// Whether it is such a file, or a folder with one.
bool HoldsNerfTransforms(const std::filesystem::path& path);

// Throws IoError with the number of the frame: missing entries, wrong types, a matrix that is not a
// rigid motion, unknown camera models, distortions that COLMAP does not have, a missing image or
// one whose aspect is not that of w x h; and for the file: invalid JSON, no frames, NeuS2's axes
// (from_na).
ImportedScene ReadNerfTransforms(const ImportInput& input);

}  // namespace limn::colmap_ext
