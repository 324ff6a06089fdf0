// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/projection_matrix.h"

namespace limn::colmap_ext {

// A PMVS folder, as image_undistorter --output_type PMVS makes it:
//   visualize/%08d.jpg         undistorted images (.ppm and .pgm are read as well)
//   txt/%08d.txt               "CONTOUR" and the 3 x 4 matrix P = K [R | t], 6 digits
//   bundle.rd.out.list.txt     the original names of the images, one per line
//   bundle.rd.out              Bundler v0.3: only its points are used

// Whether the folder has txt/00000000.txt and visualize/.
bool HoldsPmvsModel(const std::filesystem::path& folder);

// Number of files txt/%08d.txt. Throws IoError if they are not numbered consecutively from 0.
uint64_t CountPmvsImages(const std::filesystem::path& folder);

// The cameras of a PMVS folder as a model: one PINHOLE camera per image, with the size of its file,
// and the points of bundle.rd.out if it exists. Images have their original names, and `file` is the
// one in visualize/; without the list they are named after the files, with a warning.
//
// Throws IoError: an invalid number, a matrix that is not a camera (singular, or with skew), a
// missing image, a list of the wrong length, a bundle.rd.out that is damaged or of other images, or
// images that were shrunk without their matrices, as by image_undistorter --max_image_size up to
// COLMAP 4.1.0.
SparseModel ReadPmvsModel(const std::filesystem::path& folder);

// The original names of the images by PMVS number; empty if the folder has no list. Throws IoError.
std::vector<std::string> ReadPmvsImageNames(const std::filesystem::path& folder);

// Reads a file of txt/. Throws IoError.
ProjectionMatrix ReadContour(std::istream& in, const std::string& path);

}  // namespace limn::colmap_ext
