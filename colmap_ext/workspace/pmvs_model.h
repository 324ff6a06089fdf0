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
//   bundle.rd.out              Bundler v0.3: here only its points count

// Whether the folder has txt/00000000.txt and visualize/.
bool HoldsPmvsModel(const std::filesystem::path& folder);

// Number of files txt/%08d.txt. Throws IoError if the numbers do not run from 0.
uint64_t CountPmvsImages(const std::filesystem::path& folder);

// The cameras of a PMVS folder as a model: one PINHOLE camera per image, with the size of its file,
// and the points of bundle.rd.out, if it is there. Images have their original names, and as `file`
// the one in visualize/; without the list a warning says that their names are those of the files.
//
// Throws IoError: no number or a matrix that is no camera (singular, or with skew), an image that
// is missing, a list of another length, a bundle.rd.out that is damaged or of other images, and
// images that were shrunk without their matrices, as image_undistorter --max_image_size did up to
// COLMAP 4.1.0.
SparseModel ReadPmvsModel(const std::filesystem::path& folder);

// The original names of the images by PMVS number; empty if the folder has no list. Throws IoError.
std::vector<std::string> ReadPmvsImageNames(const std::filesystem::path& folder);

// One file of txt/. Throws IoError.
ProjectionMatrix ReadContour(std::istream& in, const std::string& path);

}  // namespace limn::colmap_ext
