// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A folder in the format of the Kimia lab: <frame>.extrinsic per image, with the rows of the
// rotation R and then, as the last row, the camera center C (no translation): x ~ K R (X - C). K,
// 3x3, is in <frame>.intrinsic or, for all frames without one, in calib.intrinsic.
//
// Pixel centers: integer coordinates, as in VXL.

// Whether the folder has *.extrinsic files.
bool HoldsIntrinsicExtrinsic(const std::filesystem::path& path);

// Throws IoError with file and line: wrong count of numbers, K that is not a calibration, R that is
// not a rotation, no image for a file (see MatchFilesToImages), a frame with a .origin or .scale
// file (cropped and scaled images are not supported).
ImportedScene ReadIntrinsicExtrinsic(const ImportInput& input);

}  // namespace limn::colmap_ext
