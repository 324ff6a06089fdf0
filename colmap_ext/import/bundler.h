// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// A Bundler file, version 0.3, with its list of images: list_path, or the first that exists of
// <file>.list.txt, <stem>.list.txt for a file <stem>.bundle.out, list.txt beside the file, list.txt
// in the folder above.
//
// The principal point is the center of the image, x right, y up, the camera looks along -z; k1 and
// k2 distort as in COLMAP's RADIAL (SIMPLE_PINHOLE where both are zero). Cameras with a focal
// length of zero were not reconstructed and are left out. Points keep positions, colors and
// measurements; feature indices are dropped.
//
// Pixel centers: half, that is, the center of the image is w/2 pixels from its left border.
// COLMAP's own exporter drops the principal point and one of the focal lengths.

// Whether the path is a file that begins like a Bundler file, or a folder containing *.out.
bool HoldsBundler(const std::filesystem::path& path);

// Throws IoError with the line: unsupported version, inconsistent counts, missing or non-finite
// numbers, a matrix that is not a rotation, a list of the wrong length, a missing image.
ImportedScene ReadBundler(const ImportInput& input);

}  // namespace limn::colmap_ext
