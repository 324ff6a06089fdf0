// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>

#include "colmap_ext/model/model_builder.h"

namespace limn::colmap_ext {

// Readers of the three files of a model in both formats; `path` is for messages. Layouts: COLMAP's
// documentation, "Output format". Each throws IoError (see ReadColmapModel) with byte or line. Call
// in the order cameras, images, points3D on one builder.

void ReadCamerasBinary(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadImagesBinary(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadPointsBinary(std::istream& in, const std::string& path, ModelBuilder* builder);

// Text: the rest of an image's line is its name, CR LF is accepted, '#' starts a comment line
// (except where the 2D points of an image are expected).
void ReadCamerasText(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadImagesText(std::istream& in, const std::string& path, ModelBuilder* builder);
void ReadPointsText(std::istream& in, const std::string& path, ModelBuilder* builder);

}  // namespace limn::colmap_ext
