// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/edge_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "colmap_ext/workspace/file_set.h"
#include "colmap_ext/workspace/image_reader.h"
#include "limn/edges/brighter_side.h"
#include "limn/edges/given_edgels.h"
#include "limn/files/whole_file.h"
#include "limn/formats/cem_file.h"
#include "limn/formats/edg_file.h"
#include "limn/formats/image_polylines_reader.h"
#include "limn/linking/given_curves.h"
#include "limn/model/usable_edgels.h"
#include "limn/util/errors.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEdgeExtensions[] = {".edg",    ".edg.gz", ".cem", ".cem.gz", ".txt",
                                                ".txt.gz", ".png",    ".tif", ".tiff",   ".bmp",
                                                ".pgm",    ".webp",   ".jpg", ".jpeg"};

std::string ListedExtensions() {
  std::string list;
  for (const std::string_view extension : kEdgeExtensions) list.append(" ").append(extension);
  return list;
}

// Those that exist and are none of the photographs, which may lie beside them. Throws IoError if
// only such are there.
std::vector<std::string> EdgeFilesOf(const fs::path& folder, const std::string& image_name,
                                     const FileSet& photographs) {
  const fs::path without_extension = fs::path(image_name).replace_extension();
  std::vector<std::string> files;
  for (const std::string& name : {image_name, without_extension.string()}) {
    for (const std::string_view extension : kEdgeExtensions) {
      const std::string path = (folder / name).string() + std::string(extension);
      std::error_code ignored;
      if (fs::is_regular_file(path, ignored)) files.push_back(path);
    }
    if (name == without_extension) break;
  }
  const auto is_photograph = [&](const std::string& file) { return photographs.Contains(file); };
  if (!files.empty() && std::all_of(files.begin(), files.end(), is_photograph)) {
    throw IoError(files[0], "is an image itself, not its edges (edges_path)");
  }
  std::erase_if(files, is_photograph);
  return files;
}

// A file that fits two images is that of neither.
void CheckDistinct(const std::vector<std::string>& files, const ViewSet& set) {
  std::map<std::string, std::string> image_of_file;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string& name = set.views[i].name;
    const auto [other, is_new] = image_of_file.emplace(files[i], name);
    if (!is_new) {
      throw IoError(files[i], "may be the edges of \"" + other->second + "\" or of \"" + name +
                                  "\": name it by the whole name of its image");
    }
  }
}

void CheckEdgeSize(const std::string& path, ImageSize edges, ImageSize stored, ImageSize used) {
  if (edges == stored || edges == used) return;
  throw IoError(path, "the edges of an image of " + Text(edges) + " pixels, but theirs has " +
                          Text(stored) + (used == stored ? "" : ", or " + Text(used) + " as used"));
}

float GrayLevel(const std::string& path, const Image& image, size_t pixel) {
  const float* values = image.data.data() + pixel * image.channels;
  if (!std::all_of(values, values + image.channels, [&](float v) { return v == values[0]; })) {
    throw IoError(path, "is not a map of edges: it has colors");
  }
  return values[0];
}

// Decodes only maps of the right size.
ProbabilityMap ReadProbabilityMap(const std::string& path, ImageSize stored, ImageSize used) {
  const CheckedImage checked = CheckImage(path, -1);
  CheckEdgeSize(path, checked.size, stored, used);
  const auto& complaint = checked.complaint;
  if (complaint && complaint->is_damage) throw IoError(path, complaint->text);
  const Image image = ReadImage(path);
  ProbabilityMap map{image.width, image.height, {}};
  map.values.reserve(image.data.size() / image.channels);
  size_t num_bright = 0;
  for (size_t i = 0; i < image.data.size() / image.channels; ++i) {
    map.values.push_back(GrayLevel(path, image, i) / 255);
    num_bright += map.values.back() > 0.5f;
  }
  if (2 * num_bright > map.values.size()) {
    throw IoError(path,
                  "is not a map of edges: most of it is bright; edges must be bright on dark");
  }
  return map;
}

// At the size of the view.
ImageCurves ReadTextCurves(const std::string& path, ImageSize stored, ImageSize used) {
  std::vector<ImagePolyline> polylines = ReadImagePolylines(path, stored.width, stored.height);
  const Eigen::Vector2d scale(used.width / static_cast<double>(stored.width),
                              used.height / static_cast<double>(stored.height));
  for (ImagePolyline& polyline : polylines) {
    for (Eigen::Vector2d& point : polyline) point = ResizedPlace(point, scale);
  }
  return CurvesOfPolylines(polylines, used.width, used.height);
}

void DirectFragments(const Image& image, ImageCurves* curves) {
  std::vector<Edgel>& edgels = curves->edge_map.edgels;
  for (CurveFragment& fragment : curves->fragments) {
    double brighter = 0;
    for (const EdgelId id : fragment.edgel_ids) brighter += BrighterSide(image, edgels[id]);
    if (brighter < 0) TurnAround(&fragment, &edgels);
  }
}

// Fragments are cut where edgels of theirs go.
void KeepOnly(const std::vector<bool>& keep, ImageCurves* curves) {
  RemoveUnusableEdgels(keep, curves);
  std::vector<Edgel> kept;
  std::vector<EdgelId> new_ids;
  for (size_t i = 0; i < keep.size(); ++i) {
    new_ids.push_back(static_cast<EdgelId>(kept.size()));
    if (keep[i]) kept.push_back(curves->edge_map.edgels[i]);
  }
  curves->edge_map.edgels = std::move(kept);
  for (CurveFragment& fragment : curves->fragments) {
    for (EdgelId& id : fragment.edgel_ids) id = new_ids[id];
  }
}

}  // namespace

std::vector<std::string> FindEdgeFiles(const std::string& folder, const ViewSet& set) {
  if (std::error_code ignored; !fs::is_directory(folder, ignored)) {
    throw IoError(folder, "no such folder (edges_path)");
  }
  std::vector<std::string> paths;
  for (const ViewFile& file : set.files) paths.push_back(file.image_path);
  const FileSet photographs(paths);
  std::vector<std::string> result;
  std::vector<std::string> missing;
  for (const View& view : set.views) {
    const std::vector<std::string> files = EdgeFilesOf(folder, view.name, photographs);
    if (files.size() > 1) {
      throw IoError(files[0], "and " + files[1] + " are both edges of image \"" + view.name +
                                  "\": remove one of them");
    }
    if (files.empty()) missing.push_back(view.name);
    if (!files.empty()) result.push_back(files[0]);
  }
  if (!missing.empty()) {
    throw IoError(folder, "has no edges of " + std::to_string(missing.size()) + " of " +
                              std::to_string(set.views.size()) + " images (" + ListNames(missing) +
                              "): their names, with or without extension, and one of" +
                              ListedExtensions());
  }
  CheckDistinct(result, set);
  return result;
}

GivenEdges ReadEdgeFile(const std::string& path, const ViewSet& set, ViewId view,
                        const RidgeOptions& maps) {
  const PinholeCamera& camera = set.views[view].camera;
  const ImageSize stored = set.files[view].stored_size;
  const ImageSize used{camera.width, camera.height};
  const std::string extension = FileExtension(path);
  const bool is_text = extension == ".txt";
  const bool is_map = !is_text && extension != ".edg" && extension != ".cem";
  GivenEdges given;
  ImageCurves& curves = given.curves;
  given.are_linked = extension == ".cem" || is_text;
  if (extension == ".edg") curves.edge_map = ReadEdg(path);
  if (extension == ".cem") curves = ReadCem(path);
  if (is_text) curves = ReadTextCurves(path, stored, used);
  if (is_map) curves.edge_map = DetectRidges(ReadProbabilityMap(path, stored, used), maps);
  CheckEdgeSize(path, {curves.edge_map.width, curves.edge_map.height}, stored, used);
  ResizeEdgeMap(used.width, used.height, &curves.edge_map);
  SetUnknownSigmas(&curves.edge_map);
  if (!given.are_linked) ThinEdgels(&curves.edge_map);
  MakeConsistent(&curves);
  KeepOnly(OutsideCrowds(curves.edge_map), &curves);
  if (is_text) DirectFragments(ReadViewImage(set, view), &curves);
  if (is_map) DirectByBrightness(ReadViewImage(set, view), &curves.edge_map.edgels);
  KeepOnly(OutsideMask(curves.edge_map, ReadViewMask(set, view)), &curves);
  return given;
}

}  // namespace limn::colmap_ext
