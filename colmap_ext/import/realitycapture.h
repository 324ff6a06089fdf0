// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// "Internal/External camera parameters" of RealityCapture (RealityScan), a .csv: an optional line
// "#cameras ...", then the names of the columns, then a line per image. Columns, in any order: name
// (of the image), x, y, alt (position), heading, pitch, roll (degrees), f; and, zero where there is
// none, px, py, k1, k2, k3, k4, t1, t2. Others are skipped.
//
// A camera with angles of zero looks down (-z) with its upper side to y (north) and its right side
// to x (east): heading turns it clockwise seen from above, then pitch lifts the view from straight
// down, about the camera's x, then roll turns it about its y. The focal length f is in mm of a film
// of 36 mm for the longer side of the image; px and py are relative to that side, from the center.
// Cameras become PINHOLE, OPENCV or FULL_OPENCV (brown_lens.h; t1 and t2 are OpenCV's p1 and p2).
//
// Pixel centers: half, as the center of the image is w/2 from its border.

// Whether it is such a file, or a folder with one.
bool HoldsRealityCapture(const std::filesystem::path& path);

// Throws IoError with the line: missing columns or words, numbers that are none, a missing image.
ImportedScene ReadRealityCapture(const ImportInput& input);

}  // namespace limn::colmap_ext
