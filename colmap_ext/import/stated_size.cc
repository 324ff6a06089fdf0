// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/stated_size.h"

#include <cmath>

namespace limn::colmap_ext {

void SetStatedSize(double width, double height, const FoundImage& found, const FilePlace& place,
                   ImportedImage* image) {
  constexpr double kMaxSide = 1e6;
  const auto is_side = [&](double side) {
    return side >= 1 && side <= kMaxSide && side == std::floor(side);
  };
  if (!is_side(width) || !is_side(height)) place.Fail("width and height are no size of an image");
  const ImageSize stated{static_cast<int>(width), static_cast<int>(height)};
  if (!IsResized(found.size, width, height)) {
    place.Fail("image \"" + found.name + "\" has " + Text(found.size) +
               " pixels, but width and height are " + std::to_string(stated.width) + " and " +
               std::to_string(stated.height) + ": another aspect, so not its camera");
  }
  image->camera.width = static_cast<uint64_t>(stated.width);
  image->camera.height = static_cast<uint64_t>(stated.height);
  image->file_size = found.size;
}

void SetSizeOfFile(const FoundImage& found, ImportedImage* image) {
  image->camera.width = static_cast<uint64_t>(found.size.width);
  image->camera.height = static_cast<uint64_t>(found.size.height);
  image->file_size = found.size;
}

std::string NoteResized(const std::vector<ImportedImage>& images) {
  size_t count = 0;
  const ImportedImage* first = nullptr;
  for (const ImportedImage& image : images) {
    const bool is_resized = image.file_size.width > 0 &&
                            (static_cast<uint64_t>(image.file_size.width) != image.camera.width ||
                             static_cast<uint64_t>(image.file_size.height) != image.camera.height);
    if (!is_resized) continue;
    ++count;
    if (!first) first = &image;
  }
  if (!first) return "";
  return std::to_string(count) + " images have another size than their cameras (" + first->name +
         " " + Text(first->file_size) + ", its camera " + std::to_string(first->camera.width) +
         " x " + std::to_string(first->camera.height) +
         "), but its aspect: cameras are rescaled wherever the model is used";
}

}  // namespace limn::colmap_ext
