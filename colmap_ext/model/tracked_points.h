// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/files/text_scanner.h"

namespace limn::colmap_ext {

// Index of the image of each camera in a file; -1 = skipped.
using ImageOfCamera = std::vector<int>;

// The points of a Bundler or VisualSFM file.
struct TrackedPoints {
  // Tracks refer to images by index + 1.
  std::vector<ModelPoint> points;
  // Per image, in the pixels of the file.
  std::vector<std::vector<Observation>> observations;
};

// Reads points as Bundler and VisualSFM write them: position, color, then the number of
// measurements and, for each, camera index, feature index, x and y. Measurements of skipped cameras
// are dropped. Throws IoError with the line: missing or non-finite numbers, colors outside 0..255,
// an invalid camera index.
TrackedPoints ReadTrackedPoints(int count, const ImageOfCamera& image_of_camera,
                                TextScanner* scanner);

}  // namespace limn::colmap_ext
