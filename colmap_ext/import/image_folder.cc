#include "colmap_ext/import/image_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr std::array kImageExtensions = {".png", ".jpg", ".jpeg", ".tif",  ".tiff",
                                         ".bmp", ".ppm", ".pgm",  ".webp", ".jp2"};

bool IsImage(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kImageExtensions.begin(), kImageExtensions.end(), extension) !=
         kImageExtensions.end();
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// `path` relative to `folder`; empty if it is not inside.
fs::path Inside(const fs::path& path, const fs::path& folder) {
  std::error_code ignored;
  const fs::path relative =
      fs::absolute(path, ignored)
          .lexically_normal()
          .lexically_relative(fs::absolute(folder, ignored).lexically_normal());
  if (relative.empty() || relative == "." || *relative.begin() == "..") return {};
  return relative;
}

}  // namespace

ImageFolder::ImageFolder(fs::path path, bool skip_missing)
    : path_(std::move(path)), skip_missing_(skip_missing) {
  std::error_code ignored;
  if (!fs::is_directory(path_, ignored)) throw IoError(path_.string(), "no such folder of images");
}

std::vector<std::string> ImageFolder::Names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) {
    if (entry.is_regular_file() && IsImage(entry.path())) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<FoundImage> ImageFolder::Find(const std::string& name, const fs::path& base,
                                            const FilePlace& place) {
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  for (const fs::path& candidate :
       {path_ / name, base / name, path_ / fs::path(slashed).filename()}) {
    const fs::path inside = Inside(candidate, path_);
    if (inside.empty() || !IsFile(candidate)) continue;
    return FoundImage{inside.generic_string(), ReadImageSize(candidate)};
  }
  if (!skip_missing_) {
    place.Fail("image \"" + name + "\" is not in the image folder " + path_.string());
  }
  missing_.push_back(name);
  return std::nullopt;
}

}  // namespace limn::colmap_ext
