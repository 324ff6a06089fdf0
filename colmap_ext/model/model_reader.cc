// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/model_reader.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/model/model_files.h"
#include "colmap_ext/model/mounted_images.h"
#include "colmap_ext/model/record_reading.h"
#include "colmap_ext/model/rig_files.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ReadFile = void (*)(std::istream&, const std::string&, ModelBuilder*);

struct Flavor {
  const char* extension;
  ReadFile cameras;
  ReadFile images;
  ReadFile points;
  std::vector<Rig> (*rigs)(std::istream&, const std::string&);
  std::vector<Frame> (*frames)(std::istream&, const std::string&);
};

constexpr Flavor kBinary = {".bin",           ReadCamerasBinary, ReadImagesBinary,
                            ReadPointsBinary, ReadRigsBinary,    ReadFramesBinary};
constexpr Flavor kText = {".txt",         ReadCamerasText, ReadImagesText,
                          ReadPointsText, ReadRigsText,    ReadFramesText};

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// What is there but no regular file is refused where it is opened.
bool IsThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path FileOf(const fs::path& folder, const char* stem, const Flavor& flavor) {
  return folder / (std::string(stem) + flavor.extension);
}

bool IsComplete(const fs::path& folder, const Flavor& flavor) {
  return IsFile(FileOf(folder, "cameras", flavor)) && IsFile(FileOf(folder, "images", flavor));
}

[[noreturn]] void FailIncomplete(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw IoError(folder.string(), "no such folder");
  std::string missing = MissingColmapFile(folder);
  if (missing.empty()) {
    missing = "cameras.bin and images.bin (or .txt) expected, neither of them found";
  }
  throw IoError(folder.string(), "not a COLMAP model: " + missing);
}

// As COLMAP, which asks for all three files; then whatever has poses.
const Flavor& FlavorOf(const fs::path& folder) {
  for (const Flavor* flavor : {&kBinary, &kText}) {
    if (IsComplete(folder, *flavor) && IsThere(FileOf(folder, "points3D", *flavor))) {
      return *flavor;
    }
  }
  if (IsComplete(folder, kBinary)) return kBinary;
  if (IsComplete(folder, kText)) return kText;
  FailIncomplete(folder);
}

void Read(ReadFile read, const fs::path& path, ModelBuilder* builder) {
  std::ifstream in = OpenFile(path.string());
  read(in, path.string(), builder);
  if (in.bad()) throw IoError(path.string(), "read error");
}

// Rigs and frames say something only together.
void ReadRigsAndFrames(const fs::path& folder, const Flavor& flavor, SparseModel* model) {
  const fs::path rigs_path = FileOf(folder, "rigs", flavor);
  const fs::path frames_path = FileOf(folder, "frames", flavor);
  if (IsThere(rigs_path) != IsThere(frames_path)) {
    model->warnings.push_back((IsThere(rigs_path) ? frames_path : rigs_path).string() +
                              " is missing: continuing with the poses of the images file");
  }
  if (!IsThere(rigs_path) || !IsThere(frames_path)) return;
  std::ifstream rigs = OpenFile(rigs_path.string());
  std::ifstream frames = OpenFile(frames_path.string());
  model->rigs = flavor.rigs(rigs, rigs_path.string());
  model->frames = flavor.frames(frames, frames_path.string());
  ApplyRigs(model);
}

void WarnAboutSecondFlavor(const fs::path& folder, ModelBuilder* builder) {
  if (!IsComplete(folder, kBinary) || !IsComplete(folder, kText)) return;
  std::error_code ignored;
  const bool newer_text = fs::last_write_time(FileOf(folder, "images", kText), ignored) >
                          fs::last_write_time(FileOf(folder, "images", kBinary), ignored);
  if (newer_text) {
    builder->Warn(
        folder.string() +
        ": images.txt is newer than images.bin; the binary files were read, as in COLMAP");
  }
}

}  // namespace

bool HoldsColmapModel(const fs::path& folder) {
  return IsComplete(folder, kBinary) || IsComplete(folder, kText);
}

std::string MissingColmapFile(const fs::path& folder) {
  if (HoldsColmapModel(folder)) return "";
  for (const Flavor* flavor : {&kText, &kBinary}) {
    const std::string cameras = FileOf("", "cameras", *flavor).string();
    const std::string images = FileOf("", "images", *flavor).string();
    const auto fault_of = [&](const std::string& name) {
      return name + (IsThere(folder / name) ? " is a folder, a pipe or a device" : " is missing");
    };
    if (IsFile(folder / cameras)) return fault_of(images) + " beside " + cameras;
    if (IsFile(folder / images)) return fault_of(cameras) + " beside " + images;
  }
  return "";
}

uint64_t CountColmapImages(const fs::path& folder) {
  const Flavor& flavor = FlavorOf(folder);
  const fs::path path = FileOf(folder, "images", flavor);
  std::ifstream in = OpenFile(path.string());
  if (&flavor == &kBinary) {
    ByteReader reader(path.string(), in);
    return ReadCount(reader, "number of images", 73);
  }
  LineReader reader(in, path.string());
  uint64_t count = 0;
  for (; reader.NextRecord(); ++count) reader.NextLine();
  return count;
}

SparseModel ReadColmapModel(const fs::path& folder) {
  const Flavor& flavor = FlavorOf(folder);
  ModelBuilder builder;
  WarnAboutSecondFlavor(folder, &builder);
  Read(flavor.cameras, FileOf(folder, "cameras", flavor), &builder);
  Read(flavor.images, FileOf(folder, "images", flavor), &builder);
  const fs::path points = FileOf(folder, "points3D", flavor);
  if (IsThere(points)) {
    Read(flavor.points, points, &builder);
  } else {
    builder.Warn(points.string() + " is missing: continuing with the poses alone");
  }
  SparseModel model = builder.Finish();
  model.folder = folder;
  model.flavor = &flavor == &kBinary ? ModelFlavor::kBinary : ModelFlavor::kText;
  ReadRigsAndFrames(folder, flavor, &model);
  return model;
}

}  // namespace limn::colmap_ext
