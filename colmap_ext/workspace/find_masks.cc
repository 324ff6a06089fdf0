// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/find_masks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <unordered_map>

#include "colmap_ext/workspace/file_set.h"
#include "colmap_ext/workspace/folder_search.h"
#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/name_encoding.h"
#include "colmap_ext/workspace/picture_names.h"
#include "limn/files/text_file.h"
#include "limn/util/errors.h"
#include "limn/util/lower_case.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

bool IsRegularFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// Without the word "mask" at either end and what joins it to the rest; nothing if it is not there.
std::optional<std::string> WithoutMaskWord(const std::string& name) {
  constexpr std::string_view kJoints = "_-. ";
  const std::string lower = LowerCase(name);
  for (const std::string_view word : {"masks", "mask"}) {
    const size_t size = word.size();
    if (lower.size() <= size + 1) continue;
    const size_t joint = lower.size() - size - 1;
    if (lower.ends_with(word) && kJoints.find(lower[joint]) != kJoints.npos) {
      return name.substr(0, joint);
    }
    if (lower.starts_with(word) && kJoints.find(lower[size]) != kJoints.npos) {
      return name.substr(size + 1);
    }
  }
  return std::nullopt;
}

// Names that the image of a mask may have, by how sure they are: the name before the extension of
// the mask; the same without the word "mask".
std::vector<std::string> ImagesOfMask(const std::string& file_name) {
  const auto name = WithoutPictureExtension(file_name);
  if (!name) return {};
  std::vector<std::string> images = {*name};
  if (auto without_word = WithoutMaskWord(*name)) images.push_back(std::move(*without_word));
  return images;
}

struct SplitPath {
  std::string folder, name;
};

SplitPath Split(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {"", path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

// The text of a name, or its bytes if that is unknown.
std::string NameText(const std::string& bytes) {
  return TextOfName(bytes, NameEncodings().front()).value_or(bytes);
}

// An image as its masks may name it: by its name in the model and by that of its file.
struct MaskedImage {
  std::string name;
  std::string stored_name;
  std::vector<SplitPath> texts;
};

MaskedImage MaskedImageOf(const ModelImage& image) {
  return {image.name, image.StoredName(), {Split(NameText(image.StoredName()))}};
}

// Pictures in a folder of masks by what they are called.
class MaskIndex {
 public:
  MaskIndex(const std::vector<std::string>& files) {
    for (size_t i = 0; i < files.size(); ++i) {
      const auto [folder, name] = Split(NameText(files[i]));
      const std::vector<std::string> images = ImagesOfMask(name);
      for (size_t rank = 0; rank < images.size(); ++rank) {
        Add(folder, images[rank], 2 * rank, static_cast<int>(i));
        if (const auto stem = WithoutPictureExtension(images[rank])) {
          Add(folder, *stem, 2 * rank + 1, static_cast<int>(i));
        }
      }
    }
  }

  // The masks that an image has in its own sub-folder, else in any: those of the best rank.
  std::vector<int> Find(const MaskedImage& image, bool anywhere) const {
    for (size_t rank = 0; rank < kNumRanks; ++rank) {
      std::set<int> found;
      for (const SplitPath& text : image.texts) {
        for (const std::string& name :
             {text.name, WithoutPictureExtension(text.name).value_or("")}) {
          const Names& names = anywhere ? anywhere_[rank] : here_[rank];
          const auto masks = names.find(anywhere ? name : text.folder + '/' + name);
          if (!name.empty() && masks != names.end()) {
            found.insert(masks->second.begin(), masks->second.end());
          }
        }
      }
      if (!found.empty()) return {found.begin(), found.end()};
    }
    return {};
  }

 private:
  static constexpr size_t kNumRanks = 4;
  using Names = std::unordered_map<std::string, std::vector<int>>;

  void Add(const std::string& folder, const std::string& name, size_t rank, int file) {
    here_[rank][folder + '/' + name].push_back(file);
    anywhere_[rank][name].push_back(file);
  }

  std::array<Names, kNumRanks> here_, anywhere_;
};

std::string ExpectedMask(const std::string& image_name) { return image_name + ".png"; }

[[noreturn]] void FailTwoMasks(const fs::path& folder, const std::string& image,
                               const std::string& a, const std::string& b) {
  throw IoError((folder / a).string(), "may be the mask of \"" + image + "\", and so may " + b +
                                           ": call the right one " + ExpectedMask(image));
}

[[noreturn]] void FailNoMask(const fs::path& folder, const std::string& image, size_t num_images,
                             const std::vector<std::string>& files) {
  throw IoError(folder.string(),
                "has a mask for none of the " + std::to_string(num_images) + " images: that of \"" +
                    image + "\" would be " + ExpectedMask(image) + ", " +
                    (files.empty() ? "but there is no picture" : "there is " + files.front()) +
                    " (mask_path)");
}

// Masks are given by the image, and taken by it.
class FolderMasks {
 public:
  // `unused` are the images of the model that are not in use: their masks are no other image's.
  FolderMasks(const fs::path& folder, const std::vector<MaskedImage>& images,
              const std::vector<MaskedImage>& unused, const std::vector<std::string>& image_files)
      : folder_(folder),
        images_(images),
        unused_(unused),
        paths_(images.size()),
        photographs_(image_files) {}

  FoundMasks Run() {
    for (size_t i = 0; i < images_.size(); ++i) {
      const fs::path path = folder_ / ExpectedMask(images_[i].stored_name);
      if (IsRegularFile(path)) paths_[i] = path.string();
    }
    FoundMasks found;
    if (CountMissing() > 0) FindOthers();
    if (CountMissing() == images_.size()) {
      FailNoMask(folder_, images_.front().name, images_.size(), files_);
    }
    if (num_others_ > 0) {
      found.notes.push_back(folder_.string() + ": " + std::to_string(num_others_) +
                            " masks are not named <image name>.png, but unambiguous: " + example_);
    }
    if (const size_t num_without = CountMissing(); num_without > 0) {
      found.warnings.push_back(folder_.string() + ": " + std::to_string(num_without) + " of " +
                               std::to_string(images_.size()) +
                               " images have no mask there (<image name>.png) and are used "
                               "entirely");
    }
    found.paths = std::move(paths_);
    return found;
  }

 private:
  size_t CountMissing() const { return static_cast<size_t>(std::ranges::count(paths_, "")); }

  void FindOthers() {
    std::vector<std::string> exact = paths_;
    for (const MaskedImage& image : unused_) {
      exact.push_back((folder_ / ExpectedMask(image.stored_name)).string());
    }
    const FileSet taken(exact);
    files_ = FilesBelow(folder_);
    std::erase_if(files_, [&](const std::string& file) {
      const std::string path = (folder_ / file).string();
      return !WithoutPictureExtension(file) || taken.Contains(path) || photographs_.Contains(path);
    });
    const MaskIndex index(files_);
    Assign(index, false);
    for (const MaskedImage& image : unused_) {
      const std::vector<int> masks = index.Find(image, false);
      is_taken_.insert(masks.begin(), masks.end());
    }
    Assign(index, true);
  }

  void Assign(const MaskIndex& index, bool anywhere) {
    std::map<int, size_t> image_of_mask;
    for (size_t i = 0; i < images_.size(); ++i) {
      if (!paths_[i].empty()) continue;
      std::vector<int> masks = index.Find(images_[i], anywhere);
      std::erase_if(masks, [&](int mask) { return is_taken_.contains(mask); });
      if (masks.empty()) continue;
      if (masks.size() > 1) {
        FailTwoMasks(folder_, images_[i].name, files_[masks[0]], files_[masks[1]]);
      }
      const auto [other, is_new] = image_of_mask.emplace(masks[0], i);
      if (!is_new) {
        throw IoError((folder_ / files_[masks[0]]).string(),
                      "may be the mask of \"" + images_[other->second].name + "\" or of \"" +
                          images_[i].name + "\": call it " + ExpectedMask(images_[i].name) +
                          ", or as the other one");
      }
    }
    for (const auto& [mask, image] : image_of_mask) {
      is_taken_.insert(mask);
      paths_[image] = (folder_ / files_[mask]).string();
      if (num_others_++ == 0) example_ = files_[mask] + " for " + images_[image].name;
    }
  }

  fs::path folder_;
  const std::vector<MaskedImage>& images_;
  const std::vector<MaskedImage>& unused_;
  std::vector<std::string> paths_;
  FileSet photographs_;
  std::vector<std::string> files_;  // pictures that may be masks
  std::set<int> is_taken_;
  size_t num_others_ = 0;
  std::string example_;
};

FoundMasks OneForAll(const std::string& path, size_t num_images) {
  FoundMasks found;
  found.paths.assign(num_images, path);
  found.notes = {path + " is the mask of all images"};
  return found;
}

FoundMasks MasksOfList(const std::string& path, const SparseModel& model,
                       const std::vector<int>& images) {
  std::map<std::string, std::string> mask_of_image;
  std::istringstream in(ReadTextFile(path, kMaxListBytes));
  const fs::path folder = fs::path(path).parent_path();
  uint64_t number = 0;
  for (std::string line; std::getline(in, line);) {
    const FilePlace place{path, "line", ++number};
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || (number == 1 && line.starts_with('#'))) continue;
    const size_t tab = line.find('\t');
    if (tab == std::string::npos) place.Fail("<image name><tab><path of its mask> expected");
    std::error_code error;  // what does not exist is told below
    const fs::path mask = fs::weakly_canonical(folder / line.substr(tab + 1), error);
    mask_of_image[line.substr(0, tab)] = mask.string();
  }
  FoundMasks found;
  size_t num_without = 0;
  for (const int index : images) {
    const auto mask = mask_of_image.find(model.images[index].StoredName());
    found.paths.push_back(mask == mask_of_image.end() ? "" : mask->second);
    num_without += found.paths.back().empty();
    if (!found.paths.back().empty() && !IsRegularFile(found.paths.back())) {
      throw IoError(found.paths.back(), "no such mask, which " + path + " names for \"" +
                                            model.images[index].name +
                                            "\": correct or remove that list");
    }
  }
  found.notes = {"Masks: " + path};
  if (num_without > 0) {
    found.warnings.push_back(path + ": " + std::to_string(num_without) + " of " +
                             std::to_string(images.size()) +
                             " images have no mask there and are used entirely");
  }
  return found;
}

}  // namespace

FoundMasks FindMasks(const std::string& mask_path, const SparseModel& model,
                     const std::vector<int>& images, const std::vector<std::string>& image_files) {
  if (mask_path.empty()) {
    FoundMasks none;
    none.paths.resize(images.size());
    return none;
  }
  std::error_code ignored;
  if (IsRegularFile(mask_path)) {
    return ReadSizeFromHeader(fs::path(mask_path)) ? OneForAll(mask_path, images.size())
                                                   : MasksOfList(mask_path, model, images);
  }
  if (!fs::is_directory(mask_path, ignored)) {
    throw IoError(mask_path, "no such folder (mask_path)");
  }
  std::vector<MaskedImage> masked;
  std::vector<char> is_used(model.images.size(), 0);
  for (size_t i = 0; i < images.size(); ++i) {
    is_used[images[i]] = 1;
    masked.push_back(MaskedImageOf(model.images[images[i]]));
    const SplitPath file = Split(NameText(image_files[i]));
    SplitPath in_folder = masked.back().texts.front();
    in_folder.name = file.name;
    masked.back().texts.push_back(in_folder);
  }
  std::vector<MaskedImage> unused;
  for (size_t i = 0; i < is_used.size(); ++i) {
    if (!is_used[i]) unused.push_back(MaskedImageOf(model.images[i]));
  }
  return FolderMasks(mask_path, masked, unused, image_files).Run();
}

std::string MaskListOf(const fs::path& model_dir) {
  const fs::path path = model_dir / kMaskList;
  return !model_dir.empty() && IsRegularFile(path) ? path.string() : "";
}

std::string MasksBeside(const fs::path& image_dir) {
  std::error_code error;
  const fs::path parent = fs::weakly_canonical(image_dir, error).parent_path();
  for (const char* name : {"masks", "mask", "image_masks", "images_masks", "images_mask"}) {
    for (fs::directory_iterator it(parent / name, error), end; !error && it != end;
         it.increment(error)) {
      if (WithoutPictureExtension(it->path().filename().string()) || it->is_directory(error)) {
        return (parent / name).string();
      }
    }
    error.clear();
  }
  return "";
}

}  // namespace limn::colmap_ext
