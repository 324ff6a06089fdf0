// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/products.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include "colmap_ext/model/line_reader.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

struct KindName {
  const char* name;
  DenseKind kind;
};

constexpr std::array<KindName, 4> kKinds = {{{"depth_maps", DenseKind::kDepthMaps},
                                             {"fused", DenseKind::kFusedCloud},
                                             {"pmvs", DenseKind::kPmvs},
                                             {"mesh", DenseKind::kMesh}}};

// What drawing_fuser itself writes, perhaps beside PMVS's files.
constexpr char kOwnPatches[] = "pmvs-with-curves.patch";

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// Regular files of a folder, sorted; none if it cannot be listed.
std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_regular_file()) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool HasFiles(const fs::path& folder) {
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it->is_regular_file() && it->path().extension() == ".bin") return true;
  }
  return false;
}

std::vector<fs::path> FilesWith(const fs::path& folder, const std::string& extension,
                                const std::string& prefix) {
  std::vector<fs::path> files = FilesIn(folder);
  std::erase_if(files, [&](const fs::path& file) {
    const std::string name = file.filename().string();
    return file.extension() != extension || !name.starts_with(prefix) || name == kOwnPatches;
  });
  return files;
}

Paths FirstOf(Paths files) {
  if (files.size() > 1) files.resize(1);
  return files;
}

bool IsCluster(const fs::path& file) {
  const std::string stem = file.stem().string();
  constexpr std::string_view kPrefix = "option-";
  return stem.size() > kPrefix.size() && stem.starts_with(kPrefix) &&
         std::all_of(stem.begin() + kPrefix.size(), stem.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

// The clusters of CMVS, or else the first file.
Paths ClustersOrFirst(const Paths& files) {
  Paths clusters = files;
  std::erase_if(clusters, [](const fs::path& file) { return !IsCluster(file); });
  return clusters.empty() ? FirstOf(files) : clusters;
}

Paths FindPmvs(const fs::path& folder) {
  for (const fs::path& models : {folder / "models", folder / "pmvs" / "models", folder}) {
    Paths patches = ClustersOrFirst(FilesWith(models, ".patch", ""));
    if (!patches.empty()) return patches;
    if (models == folder) continue;
    Paths points = ClustersOrFirst(FilesWith(models, ".ply", ""));
    if (!points.empty()) return points;
  }
  return {};
}

Paths IfExists(const fs::path& path) { return Exists(path) ? Paths{path} : Paths{}; }

// What a folder, or a file itself, holds of a kind.
Paths Find(DenseKind kind, const fs::path& where) {
  if (where.empty() || !Exists(where)) return {};
  std::error_code ignored;
  if (!fs::is_directory(where, ignored)) {
    const std::string extension = where.extension().string();
    const bool fits = kind == DenseKind::kPmvs   ? extension == ".patch" || extension == ".ply"
                      : kind == DenseKind::kMesh ? extension == ".ply" || extension == ".obj"
                                                 : extension == ".ply";
    return fits && kind != DenseKind::kDepthMaps ? Paths{where} : Paths{};
  }
  switch (kind) {
    case DenseKind::kDepthMaps:
      if (HasFiles(where / "stereo" / "depth_maps")) return {where / "stereo"};
      return HasFiles(where / "depth_maps") ? Paths{where} : Paths{};
    case DenseKind::kFusedCloud:
      return IfExists(where / "fused.ply");
    case DenseKind::kPmvs:
      return FindPmvs(where);
    case DenseKind::kMesh:
      return FirstOf(FilesWith(where, ".ply", "meshed-"));
  }
  return {};
}

// Where is looked, in order.
Paths PlacesOf(const DenseOptionsPaths& options, const fs::path& workspace,
               const fs::path& dense_dir) {
  Paths places = {dense_dir, workspace};
  if (!options.dense_path.empty()) {
    const fs::path given = fs::path(options.dense_path).lexically_normal();
    places = {given.has_filename() ? given : given.parent_path()};
  }
  std::erase(places, fs::path());
  return places;
}

}  // namespace

void DenseOptionsPaths::Check() const {
  const bool known = std::any_of(kKinds.begin(), kKinds.end(),
                                 [&](const KindName& kind) { return dense_type == kind.name; });
  if (dense_type != "auto" && !known) {
    throw OptionError("dense_type = " + dense_type +
                      ": must be auto, depth_maps, fused, pmvs or mesh");
  }
}

std::optional<DenseProducts> LookForDenseProducts(const DenseOptionsPaths& options,
                                                  const fs::path& workspace,
                                                  const fs::path& dense_dir) {
  options.Check();
  const Paths places = PlacesOf(options, workspace, dense_dir);
  // A PLY file with faces is a mesh unless something else is asked for.
  const bool is_mesh = options.dense_type == "auto" && !places.empty() &&
                       places.front().extension() == ".ply" && IsMeshFile(places.front());
  for (const auto& [name, kind] : kKinds) {
    if (options.dense_type != "auto" && options.dense_type != name) continue;
    if (is_mesh && kind != DenseKind::kMesh) continue;
    for (const fs::path& place : places) {
      const Paths found = Find(kind, place);
      if (found.empty()) continue;
      DenseProducts products;
      products.kind = kind;
      products.path = found.front();
      if (kind == DenseKind::kDepthMaps) {
        products.clouds = Find(DenseKind::kFusedCloud, products.path.parent_path());
      } else if (kind != DenseKind::kMesh) {
        products.clouds = found;
      }
      products.description = std::string("dense results: ") + name + ", " + products.path.string();
      if (found.size() > 1) {
        products.description += " and " + std::to_string(found.size() - 1) + " more clusters";
      }
      return products;
    }
  }
  return std::nullopt;
}

DenseProducts FindDenseProducts(const DenseOptionsPaths& options, const fs::path& workspace,
                                const fs::path& dense_dir) {
  if (auto products = LookForDenseProducts(options, workspace, dense_dir)) return *products;
  const Paths places = PlacesOf(options, workspace, dense_dir);
  const std::string wanted = options.dense_type == "auto"
                                 ? "stereo/depth_maps, fused.ply, pmvs/models or meshed-*.ply"
                                 : options.dense_type;
  throw IoError(places.empty() ? "." : places.front().string(),
                "no dense results found (looked for " + wanted +
                    "); name them by --dense_path and --dense_type");
}

bool IsMeshFile(const fs::path& path) {
  if (path.extension() == ".obj") return true;
  std::ifstream in = OpenFile(path.string());
  LineReader reader(in, path.string());
  while (reader.NextLine() && !reader.line().starts_with("end_header")) {
    const std::string& line = reader.line();
    if (line.starts_with("element face") && !line.starts_with("element face 0")) return true;
  }
  return false;
}

std::vector<fs::path> FindDenseCloud(const fs::path& workspace, const fs::path& dense_dir) {
  for (const DenseKind kind : {DenseKind::kFusedCloud, DenseKind::kPmvs}) {
    for (const fs::path& place : {dense_dir, workspace}) {
      Paths found = Find(kind, place);
      if (!found.empty()) return found;
    }
  }
  return {};
}

}  // namespace limn::colmap_ext
