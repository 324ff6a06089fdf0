// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::colmap_ext {

// The dense results that a drawing is compared with.
enum class DenseKind { kDepthMaps, kFusedCloud, kPmvs, kMesh };

struct DenseOptionsPaths {
  // "auto", or one of "depth_maps", "fused", "pmvs", "mesh".
  std::string dense_type = "auto";
  // File or folder of the dense results (stereo/, a PLY file, a .patch file, a PMVS folder) instead
  // of those found beside the model.
  std::string dense_path;

  // Throws OptionError.
  void Check() const;
};

struct DenseProducts {
  DenseKind kind = DenseKind::kDepthMaps;
  // Folder stereo/, or the file of the cloud or mesh.
  std::filesystem::path path;
  // The files of the cloud: fused.ply (also with depth maps, if it exists), or PMVS's, several if
  // CMVS made clusters (option-0000, option-0001, ...).
  std::vector<std::filesystem::path> clouds;
  std::string description;  // for the user, one line
};

// The first of depth maps, fused.ply, PMVS patches or points, and a mesh that is found in the dense
// folder or beside the model in `workspace` (pmvs/). Throws IoError with the places that were
// searched.
DenseProducts FindDenseProducts(const DenseOptionsPaths& options,
                                const std::filesystem::path& workspace,
                                const std::filesystem::path& dense_dir);

// The same; nothing if there are none.
std::optional<DenseProducts> LookForDenseProducts(const DenseOptionsPaths& options,
                                                  const std::filesystem::path& workspace,
                                                  const std::filesystem::path& dense_dir);

// Whether a file is a mesh: .obj, or a .ply with faces.
bool IsMeshFile(const std::filesystem::path& path);

// The files of the first cloud found there: fused.ply, else PMVS's. Empty if there is none.
std::vector<std::filesystem::path> FindDenseCloud(const std::filesystem::path& workspace,
                                                  const std::filesystem::path& dense_dir);

}  // namespace limn::colmap_ext
