#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A folder in the format of the Kimia lab: <frame>.extrinsic per image, with the rows of the
// rotation R and then, as the last row, the camera center C (no translation): x ~ K R (X - C). K,
// 3x3, is in <frame>.intrinsic or, for all frames without one, in calib.intrinsic.
//
// Pixel centers: integer coordinates, as in VXL.

// Whether the folder has *.extrinsic.
bool HoldsIntrinsicExtrinsic(const std::filesystem::path& path);

// Throws IoError with file and line: wrong number of numbers, K that is no calibration, R that is
// no rotation, no image for a file (see MatchFilesToImages), and for frames with a file .origin or
// .scale (cropped and scaled images), which are not read.
ImportedScene ReadIntrinsicExtrinsic(const ImportInput& input);

}  // namespace limn::colmap_ext
