// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/import/image_folder.h"
#include "colmap_ext/import/imported_scene.h"

namespace limn::colmap_ext {

// Sets the size of an image's camera to what a file states, and remembers that of the image file.
// The latter may be a resized version, as for the models of COLMAP: the camera stays that of the
// stated size, and whatever reads the model scales it. Throws IoError via `place` if the aspect
// differs by more than a pixel, or if the size is none.
void SetStatedSize(double width, double height, const FoundImage& found, const FilePlace& place,
                   ImportedImage* image);

// For formats that state no size.
void SetSizeOfFile(const FoundImage& found, ImportedImage* image);

// How many images have another size than their cameras. Empty if none has.
std::string NoteResized(const std::vector<ImportedImage>& images);

}  // namespace limn::colmap_ext
