#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/workspace/image_reader.h"

namespace limn::colmap_ext {

// An image of the image folder.
struct FoundImage {
  std::string name;  // relative to the image folder, '/' between folders, as in a COLMAP model
  ImageSize size;
};

// The folder of the images that cameras are read for.
class ImageFolder {
 public:
  // With `skip_missing` images that are not there are left out instead of being an error. Throws
  // IoError if there is no such folder.
  ImageFolder(std::filesystem::path path, bool skip_missing);

  const std::filesystem::path& path() const { return path_; }
  bool skip_missing() const { return skip_missing_; }

  // The names of the image files directly in the folder, sorted.
  std::vector<std::string> Names() const;

  // The image that a file of cameras means by `name`; the first that exists of
  //   name          in the image folder
  //   name          relative to `base`, if that leads into the image folder
  //   file name     (without folders, either slash) in the image folder
  // Throws IoError via `place` if there is none, and IoError if its size cannot be read. Nothing if
  // it is missing and missing images are skipped; they are kept count of.
  std::optional<FoundImage> Find(const std::string& name, const std::filesystem::path& base,
                                 const FilePlace& place);

  // Names that were looked for in vain.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  std::filesystem::path path_;
  bool skip_missing_;
  std::vector<std::string> missing_;
};

}  // namespace limn::colmap_ext
