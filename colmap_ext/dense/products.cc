#include "colmap_ext/dense/products.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

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

bool HasFaces(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("end_header")) {
    if (line.starts_with("element face") && !line.starts_with("element face 0")) return true;
  }
  return false;
}

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

std::optional<fs::path> FirstWith(const fs::path& folder, const std::string& extension,
                                  const std::string& prefix) {
  for (const fs::path& file : FilesIn(folder)) {
    const std::string name = file.filename().string();
    if (file.extension() == extension && name.starts_with(prefix) && name != kOwnPatches) {
      return file;
    }
  }
  return std::nullopt;
}

std::optional<fs::path> FindPmvs(const fs::path& folder) {
  for (const fs::path& models : {folder / "models", folder / "pmvs" / "models", folder}) {
    if (const auto patches = FirstWith(models, ".patch", "")) return patches;
    if (models != folder) {
      if (const auto points = FirstWith(models, ".ply", "")) return points;
    }
  }
  return std::nullopt;
}

// What a folder, or a file itself, holds of a kind.
std::optional<fs::path> Find(DenseKind kind, const fs::path& where) {
  if (where.empty() || !Exists(where)) return std::nullopt;
  std::error_code ignored;
  if (!fs::is_directory(where, ignored)) {
    const std::string extension = where.extension().string();
    const bool fits = kind == DenseKind::kPmvs   ? extension == ".patch" || extension == ".ply"
                      : kind == DenseKind::kMesh ? extension == ".ply" || extension == ".obj"
                                                 : extension == ".ply";
    return fits && kind != DenseKind::kDepthMaps ? std::optional(where) : std::nullopt;
  }
  switch (kind) {
    case DenseKind::kDepthMaps:
      if (HasFiles(where / "stereo" / "depth_maps")) return where / "stereo";
      return HasFiles(where / "depth_maps") ? std::optional(where) : std::nullopt;
    case DenseKind::kFusedCloud:
      return Exists(where / "fused.ply") ? std::optional(where / "fused.ply") : std::nullopt;
    case DenseKind::kPmvs:
      return FindPmvs(where);
    case DenseKind::kMesh:
      return FirstWith(where, ".ply", "meshed-");
  }
  return std::nullopt;
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

DenseProducts FindDenseProducts(const DenseOptionsPaths& options, const fs::path& workspace,
                                const fs::path& dense_dir) {
  options.Check();
  std::vector<fs::path> places = {dense_dir, workspace};
  if (!options.dense_path.empty()) {
    const fs::path given = fs::path(options.dense_path).lexically_normal();
    places = {given.has_filename() ? given : given.parent_path()};
  }
  // A PLY file with faces is a mesh unless something else is asked for.
  const bool is_mesh = options.dense_type == "auto" && !places.empty() &&
                       places.front().extension() == ".ply" && HasFaces(places.front());
  std::erase(places, fs::path());
  for (const auto& [name, kind] : kKinds) {
    if (options.dense_type != "auto" && options.dense_type != name) continue;
    if (is_mesh && kind != DenseKind::kMesh) continue;
    for (const fs::path& place : places) {
      const auto found = Find(kind, place);
      if (!found) continue;
      DenseProducts products = {kind, *found, {}, {}};
      if (kind == DenseKind::kDepthMaps) {
        const auto cloud = Find(DenseKind::kFusedCloud, products.path.parent_path());
        if (cloud) products.fused_cloud = *cloud;
      }
      if (kind == DenseKind::kFusedCloud) products.fused_cloud = *found;
      products.description = std::string("dense results: ") + name + ", " + found->string();
      return products;
    }
  }
  const std::string wanted = options.dense_type == "auto"
                                 ? "stereo/depth_maps, fused.ply, pmvs/models or meshed-*.ply"
                                 : options.dense_type;
  throw IoError(places.empty() ? "." : places.front().string(),
                "no dense results found (looked for " + wanted +
                    "); name them by --dense_path and --dense_type");
}

}  // namespace limn::colmap_ext
