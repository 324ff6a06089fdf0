// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// <name>_par.txt of the Middlebury multi-view benchmark: the number of images, then one line each:
// name k11 k12 ... k33 r11 r12 ... r33 t1 t2 t3, with x ~ K (R X + t). Names contain no white
// space.
//
// Pixel centers: integer coordinates.

bool HoldsMiddlebury(const std::filesystem::path& path);

// Throws IoError with the line: a wrong count of lines, missing or non-finite numbers, K that is
// not a calibration, R that is not a rotation, a missing image.
ImportedScene ReadMiddlebury(const ImportInput& input);

}  // namespace limn::colmap_ext
