// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/file_matching.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

std::string Stem(const fs::path& path) { return path.stem().string(); }

// The last run of digits of a name, without leading zeros; nothing if it has none.
std::optional<std::string> LastNumber(const fs::path& path) {
  const std::string stem = Stem(path);
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto end = std::find_if(stem.rbegin(), stem.rend(), is_digit);
  if (end == stem.rend()) return std::nullopt;
  const auto begin = std::find_if_not(end, stem.rend(), is_digit);
  const std::string digits(begin.base(), end.base());
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

using Keys = std::map<std::string, std::vector<std::string>>;

template <typename KeyOf>
Keys Index(const std::vector<std::string>& names, const KeyOf& key_of) {
  Keys keys;
  for (const std::string& name : names) {
    if (const std::optional<std::string> key = key_of(name)) keys[*key].push_back(name);
  }
  return keys;
}

// Nothing if no file finds an image. Otherwise all must, or are left out.
template <typename KeyOf>
std::optional<FileMatches> MatchByKey(const std::vector<fs::path>& files, const ImportInput& input,
                                      const KeyOf& key_of, const std::string& rule) {
  const Keys images = Index(input.images->Names(), key_of);
  FileMatches matches;
  std::map<std::string, fs::path> used;
  const fs::path* unmatched = nullptr;
  for (const fs::path& file : files) {
    const std::optional<std::string> key = key_of(file);
    const auto found = key ? images.find(*key) : images.end();
    matches.names.push_back(found == images.end() ? "" : found->second.front());
    if (found == images.end()) {
      if (!unmatched) unmatched = &file;
      continue;
    }
    if (found->second.size() > 1) {
      throw IoError(file.string(), "two images fit by " + rule + ": " + found->second[0] + " and " +
                                       found->second[1] + "; give a --list_path");
    }
    const auto [other, is_new] = used.emplace(found->second.front(), file);
    if (!is_new) {
      throw IoError(file.string(), "fits the same image by " + rule + " as " +
                                       other->second.filename().string() + ": " + other->first +
                                       "; give a --list_path");
    }
  }
  if (used.empty()) return std::nullopt;
  if (unmatched && !input.images->skip_missing()) {
    throw IoError(unmatched->string(), "no image in " + input.images->path().string() +
                                           " fits by " + rule +
                                           ", as others do; --skip_missing_images 1 leaves it out");
  }
  matches.note = std::to_string(used.size()) + " of " + std::to_string(files.size()) +
                 " camera files matched to images by " + rule;
  return matches;
}

FileMatches MatchInOrder(const std::vector<fs::path>& files, std::vector<std::string> names,
                         const std::string& rule) {
  FileMatches matches;
  matches.note = std::to_string(files.size()) + " camera files matched to images by " + rule +
                 ": " + files.front().filename().string() + " is of " + names.front() + ", " +
                 files.back().filename().string() + " is of " + names.back();
  matches.names = std::move(names);
  return matches;
}

}  // namespace

FileMatches MatchFilesToImages(const std::vector<fs::path>& files, const ImportInput& input) {
  const auto count = [](size_t n) { return std::to_string(n); };
  if (!input.list_path.empty()) {
    std::vector<std::string> names = ReadImageList(input.list_path);
    if (names.size() != files.size()) {
      throw IoError(input.list_path, count(names.size()) + " images listed, but there are " +
                                         count(files.size()) + " camera files");
    }
    return MatchInOrder(files, std::move(names), "the list");
  }
  const auto stem = [](const fs::path& path) { return std::optional(Stem(path)); };
  if (auto matches = MatchByKey(files, input, stem, "name")) return *matches;
  if (auto matches = MatchByKey(files, input, LastNumber, "number")) return *matches;
  std::vector<std::string> names = input.images->Names();
  if (names.size() != files.size()) {
    throw IoError(input.images->path().string(),
                  "no image fits a camera file by name or number, and for matching by order there "
                  "are " +
                      count(names.size()) + " images but " + count(files.size()) +
                      " camera files; give a --list_path");
  }
  std::sort(names.begin(), names.end(), NaturallyLess);
  return MatchInOrder(files, std::move(names), "order");
}

ImportedScene ReadCameraFiles(
    const std::vector<fs::path>& files, const ImportInput& input,
    const std::function<void(const ImageSize& size, ImportedImage* image)>& read) {
  const FileMatches matches = MatchFilesToImages(files, input);
  ImportedScene scene;
  scene.notes = {matches.note};
  for (size_t i = 0; i < files.size(); ++i) {
    if (matches.names[i].empty()) continue;
    ImportedImage image;
    image.path = files[i].string();
    const auto found = input.images->Find(matches.names[i], {}, {image.path, "line", 1});
    if (!found) continue;
    image.name = found->name;
    read(found->size, &image);
    scene.images.push_back(std::move(image));
  }
  return scene;
}

}  // namespace limn::colmap_ext
