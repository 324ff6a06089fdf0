#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A VisualSFM file, NVM_V3: cameras (name, focal length, quaternion w x y z, camera center, radial
// distortion, 0) and points with their measurements. Of several models in a file the one with most
// images is read, or number model_index. Double quotes in names stand for blanks.
//
// The principal point is the center of the image. VisualSFM has its measurements relative to it;
// COLMAP's exporter writes them from the corner of the image. A file without any negative one is
// taken for the latter, which is said.
//
// A camera without distortion becomes SIMPLE_PINHOLE. VisualSFM's distortion maps the other way
// than those of COLMAP (see measurement_distortion.h); it becomes FULL_OPENCV, with less than 0.001
// px of error at any place of the image, or is refused.
//
// Pixel centers: half, that is, the center of the image lies w/2 pixels from its left border.

bool HoldsNvm(const std::filesystem::path& path);

// Throws IoError with the line: other versions and fixed calibrations (NVM_V3 FixedK), counts that
// do not fit, missing or non-finite numbers, a zero quaternion, a focal length that is not
// positive, a distortion too strong, a missing image, no model of this index.
ImportedScene ReadNvm(const ImportInput& input);

}  // namespace limn::colmap_ext
