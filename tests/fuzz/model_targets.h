// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/model/model_files.h"
#include "fuzz/fuzz_target.h"

namespace limn::fuzz {

// A reader of one file of a model.
using ReadModelFile = void (*)(std::istream&, const std::string&, colmap_ext::ModelBuilder*);

// The cameras, and what becomes of the corners of their images.
int FuzzCameras(const uint8_t* data, size_t size, ReadModelFile read);
// Images of the cameras 1 (PINHOLE) and 2 (EQUIRECTANGULAR).
int FuzzImages(const uint8_t* data, size_t size, ReadModelFile read);
// Points seen in the images 1 and 2.
int FuzzPoints(const uint8_t* data, size_t size, ReadModelFile read);

}  // namespace limn::fuzz
