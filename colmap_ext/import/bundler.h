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
// measurements, and lose the indices of features.
//
// Pixel centers: half, that is, the center of the image lies w/2 pixels from its left border.
// COLMAP's own export to this format drops the principal point, and one of the focal lengths.

// Whether it is a file that begins as Bundler's do, or a folder with *.out.
bool HoldsBundler(const std::filesystem::path& path);

// Throws IoError with the line: another version, counts that do not fit, missing or non-finite
// numbers, a matrix that is no rotation, a list of another length, a missing image.
ImportedScene ReadBundler(const ImportInput& input);

}  // namespace limn::colmap_ext
