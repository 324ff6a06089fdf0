// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/image_folder.h"

#include <algorithm>
#include <utility>

#include "colmap_ext/workspace/folder_search.h"
#include "colmap_ext/workspace/picture_names.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Behind the key of an image by its name without extension; in no file name.
constexpr char kAnyExtension[] = "/";

bool IsImage(const std::string& name) { return WithoutPictureExtension(name).has_value(); }

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

std::optional<std::string> ImageFolder::FindByFileName(const fs::path& name,
                                                       const FilePlace& place) {
  const std::string file_name = name.filename().string();
  if (!is_indexed_) {
    is_indexed_ = true;
    for (const fs::path& file : SearchFolder(path_, 3).files) {
      if (!IsImage(file)) continue;
      const fs::path relative = file.lexically_relative(path_);
      Index& index = relative.has_parent_path() ? below_ : direct_;
      index[file.filename().string()].push_back(relative.generic_string());
      index[file.stem().string() + kAnyExtension].push_back(relative.generic_string());
    }
  }
  const std::string key = IsImage(file_name) ? file_name : file_name + kAnyExtension;
  for (const Index* index : {&direct_, &below_}) {
    const auto found = index->find(key);
    if (found == index->end()) continue;
    std::vector<std::string> fitting = found->second;
    // The same file name in the folder of another camera is another image.
    std::erase_if(fitting, [&](const fs::path& file) {
      return index == &below_ && name.has_parent_path() &&
             file.parent_path().filename() != name.parent_path().filename();
    });
    if (fitting.empty() || (fitting.size() > 1 && skip_missing_)) continue;
    if (fitting.size() > 1) {
      place.Fail("image \"" + file_name + "\" may be " + fitting[0] + " or " + fitting[1] +
                 " in the image folder " + path_.string());
    }
    return fitting.front();
  }
  return std::nullopt;
}

std::optional<FoundImage> ImageFolder::Find(const std::string& name, const fs::path& base,
                                            const FilePlace& place) {
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  for (const fs::path& candidate : {path_ / name, path_ / slashed, base / name, base / slashed,
                                    path_ / fs::path(slashed).filename()}) {
    const fs::path inside = Inside(candidate, path_);
    if (inside.empty() || !IsFile(candidate)) continue;
    return FoundImage{inside.generic_string(), ReadImageSize(candidate)};
  }
  if (const auto found = FindByFileName(slashed, place)) {
    return FoundImage{*found, ReadImageSize(path_ / *found)};
  }
  if (!skip_missing_) {
    place.Fail("image \"" + name + "\" is not in the image folder " + path_.string());
  }
  missing_.push_back(name);
  return std::nullopt;
}

}  // namespace limn::colmap_ext
