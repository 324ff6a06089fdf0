#pragma once

#include <istream>
#include <string>

#include "colmap_ext/model/model_builder.h"

namespace limn::colmap_ext {

// The three files of a model in both flavors, from a stream; `path` is for messages. Layouts:
// COLMAP's documentation, "Output format". Each throws IoError (see ReadModel) with byte or line.
// Call in the order cameras, images, points3D on one builder.

void ReadCamerasBinary(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadImagesBinary(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadPointsBinary(std::istream& in, const std::string& path, ModelBuilder* builder);

// Text: the rest of an image's line is its name, CR LF is accepted, '#' starts a comment line (not
// where the 2D points of an image are due).
void ReadCamerasText(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadImagesText(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadPointsText(std::istream& in, const std::string& path, ModelBuilder* builder);

}  // namespace limn::colmap_ext
