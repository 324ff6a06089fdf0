// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "colmap_ext/workspace/image_reader.h"
#include "colmap_ext/workspace/image_size.h"
#include "colmap_ext/workspace/image_traits.h"
#include "limn/model/image.h"

namespace limn::colmap_ext {

// The source of photographs: files, or memory for the paths that have pixels there. Copies share
// the pixels. Thread-safe.
class PhotoStore {
 public:
  PhotoStore() = default;
  explicit PhotoStore(std::map<std::string, PhotoPixels> in_memory);

  bool IsInMemory(const std::string& path) const { return Find(path) != nullptr; }
  // As CheckImage, ReadImage and FileIdentity of image_reader.h and file_identity.h.
  CheckedImage Check(const std::string& path, int max_image_size) const;
  Image Read(const std::string& path, int max_image_size, const ImageForm& form = {}) const;
  // As ReadTraits and ScanPixels.
  ImageTraits Traits(const std::string& path) const;
  PixelScan Scan(const std::string& path) const;
  std::string Identity(const std::string& path) const;
  // Bytes of the file or of the pixels.
  uint64_t NumBytes(const std::string& path) const;

 private:
  const PhotoPixels* Find(const std::string& path) const;

  std::shared_ptr<const std::map<std::string, PhotoPixels>> in_memory_;
};

}  // namespace limn::colmap_ext
