// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// Cameras that Metashape (PhotoScan) exported as "Agisoft XML". A camera's transform is 4 x 4, from
// the camera (x right, y down, z forward) to the chunk; the transform of its component, else that
// of the chunk, takes this to the world (meters, if the project has a scale; maybe geocentric).
// Cameras without a transform were not aligned, and are left out. Labels, with or without
// extension, name the images. Of several chunks the one with the most aligned cameras is read, or
// that of model_index.
//
// Calibrations (pixels; cx and cy from the center of the image; P1 and P2 are OpenCV's p2 and p1):
//   frame                         PINHOLE, OPENCV or FULL_OPENCV (brown_lens.h), fx = f + b1
//   fisheye, equidistant_fisheye  OPENCV_FISHEYE, or THIN_PRISM_FISHEYE with P1 or P2
//
// Skew, b2, is dropped with a note if it moves no pixel by more than 0.5 px, else refused, as are
// P3, P4, panoramas and other lenses.
//
// Pixel centers: half, as in Metashape's manual.

// Whether it is such a file, or a folder with one.
bool HoldsMetashape(const std::filesystem::path& path);

// Throws IoError with the line: malformed XML, missing elements, numbers that are none, a matrix
// that is no rotation, a missing image or one of another aspect, a sensor without calibration.
ImportedScene ReadMetashape(const ImportInput& input);

}  // namespace limn::colmap_ext
