// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/pmvs_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_builder.h"
#include "colmap_ext/model/tracked_points.h"
#include "colmap_ext/workspace/image_reader.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundleName = "bundle.rd.out";
constexpr const char* kBundleHeader = "# Bundle file v0.3";
// Focal length, two of distortion, rotation, translation.
constexpr int kNumbersPerBundleCamera = 3 + 9 + 3;
constexpr const char* kListName = "bundle.rd.out.list.txt";
// Of the focal length. Six digits in P leave a skew of up to some 1e-4.
constexpr double kMaxSkew = 1e-3;

// "00000007" + extension.
std::string Numbered(size_t index, const char* extension) {
  char name[32];
  std::snprintf(name, sizeof(name), "%08zu%s", index, extension);
  return name;
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool IsNumberedText(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".txt" && stem.size() == 8 &&
         std::all_of(stem.begin(), stem.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string ImageFile(const fs::path& folder, size_t index) {
  for (const char* extension : {".jpg", ".ppm", ".pgm"}) {
    const std::string name = Numbered(index, extension);
    if (IsFile(folder / "visualize" / name)) return name;
  }
  throw IoError((folder / "visualize" / Numbered(index, ".jpg")).string(),
                "the image of this number is missing (.jpg, .ppm or .pgm)");
}

Camera CameraFrom(const Eigen::Matrix3d& intrinsics, ImageSize size, const std::string& path) {
  if (std::abs(intrinsics(0, 1)) > kMaxSkew * intrinsics(0, 0)) {
    throw IoError(path, "the camera has skew (" + std::to_string(intrinsics(0, 1)) +
                            " px): it is not a pinhole camera of COLMAP");
  }
  const double cx = intrinsics(0, 2);
  const double cy = intrinsics(1, 2);
  if (cx > 0.95 * size.width && cy > 0.95 * size.height) {
    throw IoError(path, "the principal point (" + std::to_string(cx) + ", " + std::to_string(cy) +
                            ") is at the corner of the " + std::to_string(size.width) + " x " +
                            std::to_string(size.height) +
                            " image: the images were shrunk without their matrices (COLMAP before "
                            "4.1.1): undistort without --max_image_size");
  }
  Camera camera;
  camera.width = static_cast<uint64_t>(size.width);
  camera.height = static_cast<uint64_t>(size.height);
  camera.params = {intrinsics(0, 0), intrinsics(1, 1), cx, cy};
  return camera;
}

DecomposedProjection ReadProjection(const fs::path& path) {
  std::ifstream in = OpenFile(path.string());
  const ProjectionMatrix projection = ReadContour(in, path.string());
  try {
    return Decompose(projection);
  } catch (const InputError& error) {
    throw IoError(path.string(), error.what());
  }
}

// The points, with observations as the file has them; without the file none.
TrackedPoints ReadBundlePoints(const fs::path& path, size_t num_images) {
  if (!IsFile(path)) return {};
  const std::string text = ReadWholeFile(path.string());
  TextScanner scanner(path.string(), text);
  if (scanner.RestOfLine() != kBundleHeader) {
    scanner.Fail(std::string("\"") + kBundleHeader + "\" expected");
  }
  const int num_cameras = scanner.Count("number of cameras");
  if (static_cast<size_t>(num_cameras) != num_images) {
    scanner.Fail(std::to_string(num_cameras) + " cameras, but txt/ has " +
                 std::to_string(num_images));
  }
  const int num_points = scanner.Count("number of points");
  for (int k = 0; k < num_cameras * kNumbersPerBundleCamera; ++k) scanner.Number("a camera");
  ImageOfCamera all(num_images);
  std::iota(all.begin(), all.end(), 0);
  return ReadTrackedPoints(num_points, all, &scanner);
}

// Bundler measures from the principal point, y up.
std::vector<Observation> InImage(std::vector<Observation> observations,
                                 const Eigen::Matrix3d& intrinsics) {
  for (Observation& observation : observations) {
    observation.position.y() *= -1;
    observation.position += intrinsics.block<2, 1>(0, 2);
  }
  return observations;
}

void AddImage(const fs::path& folder, size_t index, const std::string& name,
              std::vector<Observation> observations, ModelBuilder* builder) {
  const fs::path path = folder / "txt" / Numbered(index, ".txt");
  const std::string text_path = path.string();
  const FilePlace place{text_path, "line", 1};
  const DecomposedProjection parts = ReadProjection(path);
  ModelImage image;
  image.id = static_cast<uint32_t>(index + 1);
  image.camera_id = image.id;
  image.name = name;
  image.file = ImageFile(folder, index);
  image.cam_from_world = parts.cam_from_world;
  image.observations = InImage(std::move(observations), parts.intrinsics);
  Camera camera =
      CameraFrom(parts.intrinsics, ReadImageSize(folder / "visualize" / image.file), text_path);
  camera.id = image.camera_id;
  builder->AddCamera(std::move(camera), place);
  const Eigen::Quaterniond& q = parts.cam_from_world.rotation;
  builder->AddImage(std::move(image), {q.w(), q.x(), q.y(), q.z()}, place);
}

}  // namespace

bool HoldsPmvsModel(const fs::path& folder) {
  std::error_code ignored;
  return IsFile(folder / "txt" / Numbered(0, ".txt")) &&
         fs::is_directory(folder / "visualize", ignored);
}

uint64_t CountPmvsImages(const fs::path& folder) {
  const fs::path texts = folder / "txt";
  uint64_t count = 0;
  std::error_code error;
  for (fs::directory_iterator it(texts, error), end; !error && it != end; it.increment(error)) {
    count += IsNumberedText(it->path());
  }
  if (error) throw IoError(texts.string(), "cannot be listed: " + error.message());
  for (uint64_t i = 0; i < count; ++i) {
    const fs::path path = texts / Numbered(i, ".txt");
    if (!IsFile(path)) throw IoError(path.string(), "missing, but files of higher numbers exist");
  }
  return count;
}

SparseModel ReadPmvsModel(const fs::path& folder) {
  const uint64_t count = CountPmvsImages(folder);
  const fs::path list = folder / kListName;
  ModelBuilder builder;
  std::vector<std::string> names = ReadPmvsImageNames(folder);
  if (!IsFile(list)) {
    builder.Warn(list.string() + " is missing: images have the names of visualize/");
    for (uint64_t i = 0; i < count; ++i) names.push_back(ImageFile(folder, i));
  }
  if (names.size() != count) {
    throw IoError(list.string(), "holds the names of " + std::to_string(names.size()) +
                                     " images, txt/ has " + std::to_string(count));
  }
  TrackedPoints tracked = ReadBundlePoints(folder / kBundleName, count);
  tracked.observations.resize(count);
  for (uint64_t i = 0; i < count; ++i) {
    AddImage(folder, i, names[i], std::move(tracked.observations[i]), &builder);
  }
  for (ModelPoint& point : tracked.points) builder.AddPoint(std::move(point));
  SparseModel model = builder.Finish();
  model.folder = folder;
  return model;
}

std::vector<std::string> ReadPmvsImageNames(const fs::path& folder) {
  const fs::path path = folder / kListName;
  std::vector<std::string> names;
  if (!fs::exists(path)) return names;
  std::ifstream in = OpenFile(path.string());
  LineReader reader(in, path.string());
  while (reader.NextLine()) {
    Fields fields(reader);
    if (!fields.AtEnd()) names.emplace_back(fields.Rest());
  }
  return names;
}

ProjectionMatrix ReadContour(std::istream& in, const std::string& path) {
  LineReader reader(in, path);
  reader.NextRecord();
  if (!reader.line().starts_with("CONTOUR")) reader.Here().Fail("\"CONTOUR\" expected");
  ProjectionMatrix projection;
  for (int row = 0; row < 3; ++row) {
    if (!reader.NextRecord())
      reader.Here().Fail("the file ends before row " + std::to_string(row + 1) + " of the matrix");
    Fields fields(reader);
    for (int column = 0; column < 4; ++column) {
      projection(row, column) = fields.Number<double>("an element of P");
    }
  }
  return projection;
}

}  // namespace limn::colmap_ext
