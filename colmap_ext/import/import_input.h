// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/import/image_folder.h"
#include "colmap_ext/import/imported_scene.h"

namespace limn::colmap_ext {

// The input of every reader.
struct ImportInput {
  // A file of the format, or a folder that contains one.
  std::filesystem::path path;
  ImageFolder* images = nullptr;
  // Text file with one image name per line, in the order of the cameras. Empty = not given. Only
  // formats that do not name their images read it.
  std::string list_path;
  // Index of the model in a file with several; -1 = the one with the most images.
  int model_index = -1;
};

// The regular files in a folder whose names end with `end`, in natural order (a2 before a10). Empty
// if there is no such folder.
std::vector<std::filesystem::path> FilesEndingWith(const std::filesystem::path& folder,
                                                   const std::string& end);

// `path` if it is a file, else the only file of the folder whose name ends with one of `ends`.
// Throws IoError if there is none, or if there are several, with their names.
std::filesystem::path TheFile(const std::filesystem::path& path,
                              const std::vector<std::string>& ends);

// `path` if it is a file, else the only file of the folder that is recognized as this type
// (camera_files.h). Throws IoError if there is none, or if there are several, with their names.
std::filesystem::path TheCameraFile(const std::filesystem::path& path,
                                    const std::string& input_type);

// Whether `path` is a file whose name ends with one of `ends`, or a folder that holds one.
bool HoldsFile(const std::filesystem::path& path, const std::vector<std::string>& ends);

// Whether a file begins with this text, after white space and a byte order mark. False if it cannot
// be read.
bool BeginsWith(const std::filesystem::path& file, const std::string& text);

// The names in a list of images: one per line, blank lines left out; the two numbers that Bundler
// may write after a name are dropped. Throws IoError.
std::vector<std::string> ReadImageList(const std::string& path);

// a2 before a10: runs of digits compare as numbers.
bool NaturallyLess(const std::string& a, const std::string& b);

}  // namespace limn::colmap_ext
