// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/dense_input.h"

#include <utility>

#include "colmap_ext/dense_files/depth_sources.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "limn/formats/mesh_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Files hold the coordinates of the model that was read.
DensePointStream MovedStream(const DensePointStream& points, const Eigen::Vector3d& shift) {
  return [=](const DensePointVisitor& visit) {
    points([&](const DensePoint& point) {
      DensePoint moved = point;
      moved.position += shift;
      visit(moved);
    });
  };
}

void WarnWithoutImageNames(const fs::path& pmvs_cloud, Console* console) {
  const fs::path folder = pmvs_cloud.parent_path().parent_path();
  if (!ReadPmvsImageNames(folder).empty()) return;
  console->Say("WARNING: " + (folder / "bundle.rd.out.list.txt").string() +
               " is missing: image numbers are taken as the order of the model's images");
}

}  // namespace

DenseInput OpenDenseInput(const Scene& scene, const DenseOptionsPaths& paths,
                          const std::string& workspace_path, Console* console) {
  if (scene.view_set().HasPanoramas()) {
    throw InputError(scene.layout().model_dir.string() +
                     " has EQUIRECTANGULAR images, for which there are no dense results");
  }
  DenseInput dense;
  dense.products = FindDenseProducts(paths, workspace_path, scene.layout().dense_dir);
  console->Say(dense.products.description);
  const size_t num_images = CountRegisteredImages(scene.layout().model_dir);
  if (!dense.products.clouds.empty()) {
    dense.cloud = OpenClouds(dense.products.clouds, scene.views(), num_images);
    dense.points = MovedStream(dense.cloud->points, -scene.origin());
    console->Say(std::to_string(dense.cloud->num_points) + " dense points" +
                 (dense.cloud->has_visibility ? " with the images that see them" : ""));
  }
  switch (dense.products.kind) {
    case DenseKind::kDepthMaps: {
      const size_t count = CountDepthMaps(dense.products.path, scene.views());
      if (count == 0) throw IoError(dense.products.path.string(), "no depth map of any image");
      console->Say(std::to_string(count) + " depth maps for " +
                   std::to_string(scene.views().size()) + " images");
      dense.depths = DepthMapSource(dense.products.path, scene.views());
      break;
    }
    case DenseKind::kPmvs:
      WarnWithoutImageNames(dense.products.path, console);
      [[fallthrough]];
    case DenseKind::kFusedCloud:
      dense.depths = CloudDepthSource(dense.points, scene.views());
      break;
    case DenseKind::kMesh: {
      TriangleMesh mesh = ReadMesh(dense.products.path.string());
      for (Eigen::Vector3d& vertex : mesh.vertices) vertex -= scene.origin();
      dense.depths = MeshDepthSource(std::move(mesh), scene.views());
      break;
    }
  }
  if (!dense.cloud || dense.products.kind == DenseKind::kPmvs) return dense;
  const fs::path& fused = dense.products.clouds.front();
  if (dense.cloud->has_normals) {
    dense.for_meshers = fused;
  } else {
    console->Say("WARNING: " + fused.string() + " has no normals: nothing is written for meshers");
  }
  return dense;
}

}  // namespace limn::colmap_ext
