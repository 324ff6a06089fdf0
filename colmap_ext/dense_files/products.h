#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::colmap_ext {

// The dense results a drawing is compared with.
enum class DenseKind { kDepthMaps, kFusedCloud, kPmvs, kMesh };

struct DenseOptionsPaths {
  // "auto", or one of "depth_maps", "fused", "pmvs", "mesh".
  std::string dense_type = "auto";
  // File or folder of the dense results, instead of those found beside the model: stereo/, a PLY
  // file, a .patch file, a PMVS folder.
  std::string dense_path;

  // Throws OptionError.
  void Check() const;
};

struct DenseProducts {
  DenseKind kind = DenseKind::kDepthMaps;
  // Folder stereo/, or the file of the cloud or mesh.
  std::filesystem::path path;
  // The files of the cloud: fused.ply (also beside depth maps, if it is there), or PMVS's, several
  // where CMVS made clusters (option-0000, option-0001, ...).
  std::vector<std::filesystem::path> clouds;
  std::string description;  // for the user, one line
};

// The first of depth maps, fused.ply, PMVS patches or points, and a mesh that is found in the dense
// folder, or beside the model in `workspace` (pmvs/). Throws IoError saying where was looked.
DenseProducts FindDenseProducts(const DenseOptionsPaths& options,
                                const std::filesystem::path& workspace,
                                const std::filesystem::path& dense_dir);

// The same; nothing where there are none.
std::optional<DenseProducts> LookForDenseProducts(const DenseOptionsPaths& options,
                                                  const std::filesystem::path& workspace,
                                                  const std::filesystem::path& dense_dir);

// Whether a file is a surface: .obj, or a .ply with faces.
bool IsMeshFile(const std::filesystem::path& path);

// The files of the first cloud that is found there: fused.ply, else PMVS's. Empty if there is none.
std::vector<std::filesystem::path> FindDenseCloud(const std::filesystem::path& workspace,
                                                  const std::filesystem::path& dense_dir);

}  // namespace limn::colmap_ext
