// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A VisualSFM file, NVM_V3: cameras (name, focal length, quaternion w x y z, camera center, radial
// distortion, 0) and points with their measurements. If a file has several models, the one with the
// most images is read, or number model_index. Double quotes in names stand for spaces.
//
// The principal point is the center of the image. VisualSFM's measurements are relative to it;
// COLMAP's exporter writes them relative to the corner of the image. A file without negative
// measurements is assumed to come from the exporter, with a note to the user.
//
// A camera without distortion becomes SIMPLE_PINHOLE. VisualSFM's distortion maps in the opposite
// direction from COLMAP's (see measurement_distortion.h); it becomes FULL_OPENCV, with an error
// below 0.001 px everywhere in the image, or is an error.
//
// Pixel centers: half, that is, the center of the image is w/2 pixels from its left border.

bool HoldsNvm(const std::filesystem::path& path);

// Throws IoError with the line: other versions and fixed calibrations (NVM_V3 FixedK), inconsistent
// counts, missing or non-finite numbers, a zero quaternion, a focal length that is not positive, a
// distortion that is too strong, a missing image, no model of this index.
ImportedScene ReadNvm(const ImportInput& input);

}  // namespace limn::colmap_ext
