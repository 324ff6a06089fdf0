// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/select_images.h"

#include <algorithm>
#include <functional>
#include <set>
#include <system_error>
#include <utility>

#include "colmap_ext/model/image_name.h"
#include "colmap_ext/workspace/duplicate_images.h"
#include "colmap_ext/workspace/image_files.h"
#include "colmap_ext/workspace/listed_images.h"
#include "limn/util/errors.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Indices into model.images of the images to use, sorted by name.
std::vector<int> ImagesToUse(const SparseModel& model, const std::string& image_list_path) {
  std::vector<int> selected;
  ListedImages listed;
  if (!image_list_path.empty()) listed = ReadListedImages(image_list_path, model);
  for (size_t i = 0; i < model.images.size(); ++i) {
    const std::string& name = model.images[i].name;
    if (image_list_path.empty() || listed.names.contains(name)) {
      selected.push_back(static_cast<int>(i));
    }
  }
  if (!listed.unknown.empty()) {
    throw IoError(image_list_path,
                  "image \"" + listed.unknown + "\" is not registered in " + model.folder.string());
  }
  if (!image_list_path.empty() && listed.names.empty()) {
    throw InputError(image_list_path + ": names no image");
  }
  if (selected.empty()) {
    throw InputError(model.folder.string() + ": no registered image to work on");
  }
  std::sort(selected.begin(), selected.end(),
            [&](int a, int b) { return model.images[a].name < model.images[b].name; });
  return selected;
}

// Removes the images whose cameras are not in the scene.
void LeaveOutFar(const SparseModel& model, SelectedImages* selected) {
  std::vector<std::string> names;
  std::erase_if(selected->images, [&](int index) {
    const ModelImage& image = model.images[index];
    if (selected->reach.Contains(Inverse(image.cam_from_world).translation)) return false;
    names.push_back(image.name);
    return true;
  });
  if (names.empty()) return;
  selected->warnings.push_back(std::to_string(names.size()) +
                               " images are left out, since their cameras are far outside the "
                               "scene of the others: " +
                               ListNames(names));
}

// Of all images of the model, those of these.
std::vector<std::string> PathsOf(const ImageFiles& files, const std::vector<int>& selected) {
  std::vector<std::string> paths;
  for (const int index : selected) paths.push_back(files.paths[index]);
  return paths;
}

// Of images that are alike, that with the most 2D points stays.
void LeaveOutDuplicates(const SparseModel& model, const ImageFiles& files, const PhotoStore& photos,
                        const RunContext& context, SelectedImages* selected) {
  std::vector<int> ranked = selected->images;
  std::ranges::stable_sort(ranked, std::greater{},
                           [&](int index) { return model.images[index].observations.size(); });
  const std::vector<DuplicateImage> duplicates =
      FindDuplicateImages(model, ranked, PathsOf(files, ranked), context, photos);
  if (duplicates.empty()) return;
  std::vector<std::string> names;
  std::set<int> left_out;
  for (const DuplicateImage& duplicate : duplicates) {
    left_out.insert(ranked[duplicate.duplicate]);
    names.push_back(model.images[ranked[duplicate.duplicate]].name + " (of " +
                    model.images[ranked[duplicate.of]].name + ")");
  }
  selected->warnings.push_back(std::to_string(duplicates.size()) + " of " +
                               std::to_string(ranked.size()) +
                               " images are duplicates, by their bytes or by pose and picture, and "
                               "are left out: " +
                               ListNames(names));
  std::erase_if(selected->images, [&](int index) { return left_out.contains(index); });
}

bool IsMissing(const std::string& path, const PhotoStore& photos) {
  std::error_code ignored;
  return !photos.IsInMemory(path) && !fs::is_regular_file(path, ignored);
}

// Removes the images without a file; `paths` are those of all of them.
void LeaveOutMissing(const SparseModel& model, const std::vector<std::string>& paths,
                     const fs::path& image_dir, const PhotoStore& photos,
                     SelectedImages* selected) {
  std::vector<int> found;
  std::vector<std::string> names;
  for (size_t i = 0; i < paths.size(); ++i) {
    const int index = selected->images[i];
    if (IsMissing(paths[i], photos)) {
      names.push_back(model.images[index].name);
    } else {
      found.push_back(index);
    }
  }
  if (names.empty()) return;
  const std::string num_images = std::to_string(paths.size());
  if (found.empty()) {
    throw InputError(image_dir.string() + ": none of the " + num_images +
                     " images of the model is there: --image_path names their folder");
  }
  selected->images = std::move(found);
  selected->warnings.push_back(std::to_string(names.size()) + " of " + num_images +
                               " images are missing in " + image_dir.string() +
                               " and are left out (skip_missing_images): " + ListNames(names));
}

// What to do about missing files: leave them out, or look elsewhere if all are missing.
std::string WayOutOfMissing(int64_t num_missing, size_t num_images) {
  return static_cast<size_t>(num_missing) < num_images
             ? "; --skip_missing_images 1 leaves out what is missing"
             : "; none of the images is there: --image_path names their folder";
}

void CheckImagesExist(const std::vector<std::string>& paths, const fs::path& image_dir,
                      const PhotoStore& photos) {
  const auto missing = [&](const std::string& path) { return IsMissing(path, photos); };
  const auto first = std::find_if(paths.begin(), paths.end(), missing);
  if (first == paths.end()) return;
  const auto count = std::count_if(first, paths.end(), missing);
  const std::string others =
      count == 1 ? "" : " (and " + std::to_string(count - 1) + " other images)";
  std::error_code ignored;
  if (fs::exists(*first, ignored))
    throw IoError(*first, "is a folder or a pipe, not an image file");
  const bool is_link = fs::is_symlink(*first, ignored);
  const std::string hint =
      HintForMissing(image_dir, fs::path(*first).lexically_relative(image_dir).string());
  throw IoError(*first, (is_link ? "the image is a symbolic link that leads nowhere"
                                 : "the image is registered in the model but missing on disk") +
                            others + hint + WayOutOfMissing(count, paths.size()));
}

}  // namespace

SelectedImages SelectImages(const SparseModel& model, const fs::path& image_dir,
                            const std::string& image_list_path, bool skip_missing,
                            const PhotoStore& photos, const RunContext& context) {
  const std::vector<int> listed = ImagesToUse(model, image_list_path);
  SelectedImages selected = {SceneReach(model, listed), listed, {}, {}, {}};
  LeaveOutFar(model, &selected);
  ImageFiles files = FindImageFiles(model, selected.images, image_dir, photos);
  if (skip_missing) {
    LeaveOutMissing(model, PathsOf(files, selected.images), image_dir, photos, &selected);
  }
  CheckImagesExist(PathsOf(files, selected.images), image_dir, photos);
  LeaveOutDuplicates(model, files, photos, context, &selected);
  selected.paths = PathsOf(files, selected.images);
  selected.notes = std::move(files.notes);
  return selected;
}

}  // namespace limn::colmap_ext
