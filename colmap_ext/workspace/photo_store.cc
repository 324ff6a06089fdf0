// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/photo_store.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "colmap_ext/workspace/file_identity.h"
#include "limn/cache/content_hash.h"

namespace limn::colmap_ext {
namespace {

std::string_view BytesOf(const PhotoPixels& pixels) {
  return std::visit(
      [](const auto& values) {
        return std::string_view(reinterpret_cast<const char*>(values.data()),
                                values.size() * sizeof(values[0]));
      },
      pixels.values);
}

}  // namespace

PhotoStore::PhotoStore(std::map<std::string, PhotoPixels> in_memory)
    : in_memory_(std::make_shared<const std::map<std::string, PhotoPixels>>(std::move(in_memory))) {
}

const PhotoPixels* PhotoStore::Find(const std::string& path) const {
  if (!in_memory_) return nullptr;
  const auto found = in_memory_->find(path);
  return found == in_memory_->end() ? nullptr : &found->second;
}

CheckedImage PhotoStore::Check(const std::string& path, int max_image_size) const {
  if (const PhotoPixels* pixels = Find(path)) {
    CheckDecodable(path, pixels->size, max_image_size);
    return {pixels->size, std::nullopt};
  }
  return CheckImage(path, max_image_size);
}

Image PhotoStore::Read(const std::string& path, int max_image_size, const ImageForm& form) const {
  if (const PhotoPixels* pixels = Find(path)) return ImageFromPixels(*pixels, max_image_size, form);
  return ReadImage(path, max_image_size, form);
}

ImageTraits PhotoStore::Traits(const std::string& path) const {
  const PhotoPixels* pixels = Find(path);
  if (!pixels) return ReadTraits(std::filesystem::path(path));
  ImageTraits traits;
  traits.is_deep = std::holds_alternative<std::vector<uint16_t>>(pixels->values);
  return traits;
}

PixelScan PhotoStore::Scan(const std::string& path) const {
  const PhotoPixels* pixels = Find(path);
  return pixels ? ScanPixels(*pixels) : ScanPixels(std::filesystem::path(path));
}

std::string PhotoStore::Identity(const std::string& path) const {
  const PhotoPixels* pixels = Find(path);
  if (!pixels) return FileIdentity(path);
  ContentHash hash;
  hash.Add(BytesOf(*pixels));
  return "pixels " + Text(pixels->size) + " " + hash.Hex();
}

uint64_t PhotoStore::NumBytes(const std::string& path) const {
  if (const PhotoPixels* pixels = Find(path)) return BytesOf(*pixels).size();
  std::error_code ignored;
  return std::filesystem::file_size(path, ignored);
}

}  // namespace limn::colmap_ext
