// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/dense_files/depth_map.h"
#include "colmap_ext/model/model.h"
#include "limn/model/drawing_graph.h"

// Dense results of a scene that is nothing but the plane z = 0, and a drawing of it, for models
// whose images look down on that plane near the origin; everything moved by `shift`.
namespace limn::testing {

// Two links on the plane and, as link 2, one that hovers high above it; seen by all images.
DrawingGraph PlaneDrawing(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());
// Writes it as drawing.json with the names of the model's images.
void WritePlaneDrawing(const std::filesystem::path& path, const colmap_ext::SparseModel& model,
                       const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

// The depth map of an image (PINHOLE), with sides `scale` times as long.
colmap_ext::FloatMap PlaneDepthMap(const colmap_ext::SparseModel& model,
                                   const colmap_ext::ModelImage& image, double scale,
                                   const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());
// Maps of all images to <folder>/depth_maps/<name>.<kind>.bin.
void WritePlaneDepthMaps(const std::filesystem::path& stereo_dir,
                         const colmap_ext::SparseModel& model, double scale,
                         const std::string& kind = "geometric",
                         const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

// Points of the plane, one every 4 cm.
std::vector<Eigen::Vector3d> PlanePoints(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

struct PlyForm {
  bool ascii = false;
  bool normals = true;
  const char* type = "float";  // of positions
  const char* more = "";       // one more property, of type float
  uint64_t num_said = 0;       // 0 = as many as there are
};
// The points as a PLY file.
std::string PlanePly(const PlyForm& form, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

// The points as the text of a .patch file; every patch is seen by the images with these numbers.
std::string PlanePatches(const std::vector<int>& images,
                         const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

// The plane as one face, an ascii PLY file.
std::string PlaneMesh(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

// What a drawing-fused.json must say: links 0 and 1 on a surface, and link 2 without dense points.
void ExpectPlaneClasses(const std::filesystem::path& path);

}  // namespace limn::testing
