// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::colmap_ext {

// Values of --input_type of model_importer for single files, by which these are recognized.
inline constexpr char kBundlerType[] = "bundler";
inline constexpr char kNvmType[] = "nvm";
inline constexpr char kNerfTransformsType[] = "nerf_transforms";
inline constexpr char kOpensfmType[] = "opensfm";
inline constexpr char kOpenmvgType[] = "openmvg";
inline constexpr char kMetashapeType[] = "metashape";
inline constexpr char kRealityCaptureType[] = "realitycapture";

// A file in which another program keeps cameras.
struct CameraFile {
  std::filesystem::path path;
  std::string program;
  // That model_importer reads it as. Empty if it reads nothing of the kind; then `way_out` tells
  // how the program exports something that is read.
  std::string input_type;
  std::string way_out;
};

// By name and first 64 KB. Nothing if it is no such file, or cannot be read.
std::optional<CameraFile> RecognizeCameraFile(const std::filesystem::path& file);

// Whether `path` is a file of this type, or a folder that holds one.
bool HoldsCameraFile(const std::filesystem::path& path, const std::string& input_type);

// Those in a folder and up to three below: that can be read before others, then near ones before
// deep ones, then by name. Of .json and the like, at most 1,000 are looked into. Links to folders
// are not followed, and at most 20,000 entries are seen.
std::vector<CameraFile> FindCameraFiles(const std::filesystem::path& folder);

// A path as a word of a command line, in quotes where it needs some.
std::string ShellWord(const std::filesystem::path& path);

// What to do with these files to get a model into `workspace`, in one sentence that begins in lower
// case. `image_dir` is the folder of the photographs, empty if it is not known. Precondition: not
// empty.
std::string HowToImport(const std::vector<CameraFile>& files,
                        const std::filesystem::path& workspace,
                        const std::filesystem::path& image_dir);

}  // namespace limn::colmap_ext
