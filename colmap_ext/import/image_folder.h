// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/workspace/image_reader.h"

namespace limn::colmap_ext {

// An image in the image folder.
struct FoundImage {
  std::string name;  // relative to the image folder, '/' between folders, as in a COLMAP model
  ImageSize size;
};

// The folder with the images of the imported cameras.
class ImageFolder {
 public:
  // With `skip_missing`, images that do not exist are skipped instead of being an error. Throws
  // IoError if the folder does not exist.
  ImageFolder(std::filesystem::path path, bool skip_missing);

  const std::filesystem::path& path() const { return path_; }
  bool skip_missing() const { return skip_missing_; }

  // The names of the image files directly in the folder, sorted.
  std::vector<std::string> Names() const;

  // The image that a camera file calls `name`: the first that exists of
  //   name          in the image folder
  //   name          relative to `base`, if that leads into the image folder
  //   file name     (without folders, either slash) in the image folder
  //   the same      with any extension of an image, where it has none, in the image folder
  //   file name     in the folders below, with any extension where it has none; if the name has
  //                 folders, only in one of the name of its last
  // Throws IoError via `place` if there is none, or if several fit in the last two ways, and
  // IoError if its size cannot be read. Returns nothing, and records the name, if it is missing, or
  // several fit, and missing images are skipped.
  std::optional<FoundImage> Find(const std::string& name, const std::filesystem::path& base,
                                 const FilePlace& place);

  // Names of images that were not found.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  // Of images by file name, and by file name without extension: paths relative to the folder.
  using Index = std::map<std::string, std::vector<std::string>>;

  std::optional<std::string> FindByFileName(const std::filesystem::path& name,
                                            const FilePlace& place);

  std::filesystem::path path_;
  bool skip_missing_;
  bool is_indexed_ = false;
  Index direct_, below_;
  std::vector<std::string> missing_;
};

}  // namespace limn::colmap_ext
