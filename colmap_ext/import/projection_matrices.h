// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A folder with one text file per image, containing a 3x4 projection matrix P row by row:
// *.projmatrix if there are any (the Barcelona Pavilion and DTU Vase data sets), else all *.txt,
// with or without the line CONTOUR at the top (PMVS). x ~ P X; P is decomposed to K [R | t].
//
// Pixel centers: integer coordinates, as in PMVS and MATLAB-like tools. But matrices written by
// COLMAP's image_undistorter, and those of Blender cameras with the principal point at w/2, h/2,
// have them at half.

// Whether the folder has such files.
bool HoldsProjectionMatrices(const std::filesystem::path& path);

// Throws IoError with file and line: not twelve finite numbers, a singular matrix, skewed pixels,
// no image for a file (see MatchFilesToImages).
ImportedScene ReadProjectionMatrices(const ImportInput& input);

}  // namespace limn::colmap_ext
