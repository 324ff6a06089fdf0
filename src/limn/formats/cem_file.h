// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "limn/model/curve_fragment.h"

namespace limn {

// Curve fragments with their edge map in the text format of the MSEL tools (`.cem` version 2, also
// gzipped): [Edgemap] with "(x, y) dir conf d2f" per edgel and, if written by Limn, its sigma,
// [Contours] with "[id id ... ]" per fragment, [Contour Properties], which are ignored. A fragment
// whose last id equals its first is closed. Reading sets position_px and stored_px to the same
// values; there is no link graph. Throws IoError, also for edgels more than a pixel outside the
// image, numbers that are not finite, strengths and sigmas below 0, sigmas above 10 px, and
// fragments that are together longer than the image has pixels, where every edgel counts as a pixel
// at least.
ImageCurves ReadCem(const std::string& path);

// Writes positions and directions in the virtual pinhole image (in the stored one before
// ApplyLens); edgels and fragments are read back exactly. Of the properties only length (edgels)
// and mean strength are set, the others are 0.
void WriteCem(const ImageCurves& curves, std::ostream& out);

}  // namespace limn
