// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_files.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "colmap_ext/workspace/folder_search.h"
#include "colmap_ext/workspace/match_names.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

fs::path FileOf(const ModelImage& image) {
  return image.file.empty() ? image.StoredName() : image.file;
}

// The file if its name begins with that of the folder itself, as in models of images that were
// named from the folder above; else empty.
fs::path FileFromAbove(const fs::path& file, const fs::path& image_dir) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(image_dir, ignored).lexically_normal() / "";
  const fs::path name = folder.parent_path().filename();
  if (name.empty() || file.begin() == file.end() || *file.begin() != name) return {};
  const fs::path path = image_dir / file.lexically_relative(name);
  return fs::is_regular_file(path, ignored) ? path : fs::path();
}

void CheckUnambiguous(const NameMatches& matches, const std::vector<std::string>& names,
                      const std::vector<std::string>& files, const fs::path& folder) {
  if (matches.ambiguous.empty()) return;
  const AmbiguousName& first = matches.ambiguous.front();
  throw IoError((folder / names[first.name]).string(),
                "there is no image of exactly this name, but two whose names may be the same in "
                "other encodings: " +
                    files[first.file] + " and " + files[first.other_file] +
                    "; rename the right one as in the model");
}

}  // namespace

ImageFiles FindImageFiles(const SparseModel& model, const std::vector<int>& images,
                          const fs::path& image_dir, const PhotoStore& photos) {
  ImageFiles result;
  result.paths.resize(model.images.size());
  std::vector<int> missing;
  std::set<std::string> taken;
  size_t num_from_above = 0;
  for (const int index : images) {
    const fs::path file = FileOf(model.images[index]);
    result.paths[index] = (image_dir / file).string();
    std::error_code ignored;
    if (photos.IsInMemory(result.paths[index])) continue;
    if (fs::exists(fs::symlink_status(result.paths[index], ignored))) {
      taken.insert(file.lexically_normal().string());
    } else if (const fs::path path = FileFromAbove(file, image_dir); !path.empty()) {
      result.paths[index] = path.string();
      ++num_from_above;
    } else {
      missing.push_back(index);
    }
  }
  if (num_from_above > 0) {
    result.notes.push_back(std::to_string(num_from_above) +
                           " names of images begin with that of the folder " + image_dir.string() +
                           ", and are found without it");
  }
  if (missing.empty()) return result;
  std::vector<std::string> files = FilesBelow(image_dir);
  std::erase_if(files, [&](const std::string& file) { return taken.contains(file); });
  std::vector<std::string> names;
  for (const int index : missing) names.push_back(FileOf(model.images[index]).string());
  const NameMatches matches = MatchNames(names, files);
  CheckUnambiguous(matches, names, files, image_dir);
  for (size_t i = 0; i < missing.size(); ++i) {
    if (const int file = matches.file_of[i]; file >= 0) {
      result.paths[missing[i]] = (image_dir / files[file]).string();
    }
  }
  for (const std::string& way : matches.ways) {
    result.notes.push_back("Images in " + image_dir.string() +
                           " by the text of their names: " + way);
  }
  return result;
}

}  // namespace limn::colmap_ext
