#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/formats/text_scanner.h"

namespace limn::colmap_ext {

// Which image is each camera of a file; -1 = left out.
using ImageOfCamera = std::vector<int>;

// The points of a Bundler or VisualSFM file.
struct TrackedPoints {
  // Tracks refer to images by index + 1.
  std::vector<ModelPoint> points;
  // Per image, in the pixels of the file.
  std::vector<std::vector<Observation>> observations;
};

// Read points as Bundler and VisualSFM write them: position, color, then the number of
// measurements and for each camera index, feature index, x and y. Measurements of cameras that are
// left out are dropped. Throws IoError with the line: missing or non-finite numbers, colors
// outside 0..255, a camera index that is none.
TrackedPoints ReadTrackedPoints(int count, const ImageOfCamera& image_of_camera,
                                TextScanner* scanner);

}  // namespace limn::colmap_ext
