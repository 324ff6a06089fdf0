#pragma once

#include <vector>

#include "colmap_ext/import/imported_scene.h"
#include "limn/io/text_scanner.h"

namespace limn::colmap_ext {

// Which image of the scene is each camera of a file; -1 = left out.
using ImageOfCamera = std::vector<int>;

// Read points as Bundler and VisualSFM write them: position, colour, then the number of
// measurements and for each camera index, feature index, x and y. They are appended to the scene,
// measurements as observations of its images in the pixels of the file; those of cameras left out
// are dropped. Throws IoError with the line: missing or non-finite numbers, colours outside 0..255,
// a camera index that is none.
void ReadTrackedPoints(int count, const ImageOfCamera& image_of_camera, TextScanner* scanner,
                       ImportedScene* scene);

}  // namespace limn::colmap_ext
