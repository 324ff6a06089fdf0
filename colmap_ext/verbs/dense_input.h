// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "colmap_ext/dense_files/dense_cloud.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/console.h"
#include "colmap_ext/host/scene.h"
#include "limn/dense/fuse_drawing.h"

namespace limn::colmap_ext {

// The opened dense results.
struct DenseInput {
  DenseProducts products;
  DepthSource depths;
  // PMVS's or fused.ply; with depth maps, the fused cloud if there is one.
  std::optional<DenseCloud> cloud;
  // Its points, relative to the scene's origin.
  DensePointStream points;
  // fused.ply, if it exists and has the normals that meshers need; else empty.
  std::filesystem::path for_meshers;
};

// Finds and opens the dense results of a project and prints what was chosen. Throws IoError, also
// if no view has a depth map.
DenseInput OpenDenseInput(const Scene& scene, const DenseOptionsPaths& paths,
                          const std::string& workspace_path, Console* console);

}  // namespace limn::colmap_ext
