// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/fusion_scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "colmap_ext/dense_files/patch_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/write_drawing.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;

constexpr double kHalfSide = 1.6;
constexpr double kSpacing = 0.04;

DrawingLink MakeLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int node0) {
  DrawingLink link;
  for (int k = 0; k <= 10; ++k) link.points_in_world.push_back(from + 0.1 * k * (to - from));
  // Exactly, as nodes are.
  link.points_in_world.back() = to;
  link.sigma.assign(link.points_in_world.size(), 0.001);
  link.node0 = node0;
  link.node1 = node0 + 1;
  link.supporting_views = {0, 1, 2, 3, 4, 5};
  link.residual_px = 0.25;
  return link;
}

}  // namespace

DrawingGraph PlaneDrawing(const Eigen::Vector3d& shift) {
  const Eigen::Vector3d corners[] = {{-0.4, -0.3, 0}, {0.4, -0.3, 0}, {0.4, 0.3, 0}};
  DrawingGraph graph;
  graph.nodes.resize(5);
  for (int k = 0; k < 3; ++k) graph.nodes[k].position_in_world = corners[k] + shift;
  graph.nodes[3].position_in_world = Eigen::Vector3d(-0.2, 0, 0.5) + shift;
  graph.nodes[4].position_in_world = Eigen::Vector3d(0.2, 0, 0.5) + shift;
  for (const int node : {0, 1, 3}) {
    graph.links.push_back(MakeLink(graph.nodes[node].position_in_world,
                                   graph.nodes[node + 1].position_in_world, node));
  }
  RebuildIncidence(&graph);
  return graph;
}

void WritePlaneDrawing(const fs::path& path, const colmap_ext::SparseModel& model,
                       const Eigen::Vector3d& shift) {
  DrawingMetadata metadata;
  for (const colmap_ext::ModelImage& image : model.images) {
    metadata.view_names.push_back(image.name);
  }
  std::sort(metadata.view_names.begin(), metadata.view_names.end());
  metadata.options_json = "{}";
  WriteDrawing(path.string(), PlaneDrawing(shift), metadata);
}

colmap_ext::FloatMap PlaneDepthMap(const colmap_ext::SparseModel& model,
                                   const colmap_ext::ModelImage& image, double scale,
                                   const Eigen::Vector3d& shift) {
  const colmap_ext::Camera& camera = model.CameraOf(image);
  colmap_ext::FloatMap map;
  map.width = static_cast<int>(std::lround(scale * static_cast<double>(camera.width)));
  map.height = static_cast<int>(std::lround(scale * static_cast<double>(camera.height)));
  map.channels = 1;
  const Rigid3d world_from_cam = Inverse(image.cam_from_world);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Eigen::Vector3d ray((column / scale - camera.params[2]) / camera.params[0],
                                (row / scale - camera.params[3]) / camera.params[1], 1);
      const double depth =
          (shift.z() - world_from_cam.translation.z()) / (world_from_cam.rotation * ray).z();
      map.data.push_back(static_cast<float>(depth > 0 && depth < 20 ? depth : 0));
    }
  }
  return map;
}

void WritePlaneDepthMaps(const fs::path& stereo_dir, const colmap_ext::SparseModel& model,
                         double scale, const std::string& kind, const Eigen::Vector3d& shift) {
  for (const colmap_ext::ModelImage& image : model.images) {
    const fs::path path = stereo_dir / "depth_maps" / (image.name + "." + kind + ".bin");
    fs::create_directories(path.parent_path());
    colmap_ext::WriteFloatMap(PlaneDepthMap(model, image, scale, shift), path);
  }
}

std::vector<Eigen::Vector3d> PlanePoints(const Eigen::Vector3d& shift) {
  std::vector<Eigen::Vector3d> points;
  const int steps = static_cast<int>(std::lround(kHalfSide / kSpacing));
  for (int i = -steps; i <= steps; ++i) {
    for (int k = -steps; k <= steps; ++k) {
      points.push_back(Eigen::Vector3d(i * kSpacing, k * kSpacing, 0) + shift);
    }
  }
  return points;
}

std::string PlanePly(const PlyForm& form, const Eigen::Vector3d& shift) {
  const std::vector<Eigen::Vector3d> points = PlanePoints(shift);
  std::ostringstream out;
  out.precision(12);
  out << "ply\nformat " << (form.ascii ? "ascii" : "binary_little_endian") << " 1.0\n"
      << "element vertex " << (form.num_said ? form.num_said : points.size()) << '\n';
  for (const char* axis : {"x", "y", "z"}) out << "property " << form.type << ' ' << axis << '\n';
  if (form.normals) out << "property float nx\nproperty float ny\nproperty float nz\n";
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (*form.more) out << "property float " << form.more << '\n';
  out << "end_header\n";
  const auto put = [&](auto value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (const Eigen::Vector3d& point : points) {
    if (form.ascii) {
      out << point.transpose() << (form.normals ? " 0 0 1" : "") << " 9 9 9"
          << (*form.more ? " 0.5" : "") << '\n';
      continue;
    }
    for (const double value : point) {
      if (form.type == std::string_view("double")) {
        put(value);
      } else {
        put(static_cast<float>(value));
      }
    }
    for (int axis = 0; form.normals && axis < 3; ++axis) put(axis == 2 ? 1.f : 0.f);
    out << "\t\t\t";
    if (*form.more) put(0.5f);
  }
  return out.str();
}

std::string PlanePatches(const std::vector<int>& images, const Eigen::Vector3d& shift) {
  const std::vector<Eigen::Vector3d> points = PlanePoints(shift);
  std::ostringstream out;
  colmap_ext::WritePatchHeader(points.size(), out);
  for (const Eigen::Vector3d& point : points) {
    colmap_ext::Patch patch;
    patch.position = point;
    patch.normal = {0, 0, 1};
    patch.images = images;
    colmap_ext::WritePatch(patch, out);
  }
  return out.str();
}

std::string PlaneMesh(const Eigen::Vector3d& shift) {
  std::ostringstream out;
  out.precision(12);
  out << "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
         "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& [x, y] : {std::pair(-2, -2), {2, -2}, {2, 2}, {-2, 2}}) {
    out << (Eigen::Vector3d(x, y, 0) + shift).transpose() << '\n';
  }
  out << "4 0 1 2 3\n";
  return out.str();
}

void ExpectPlaneClasses(const fs::path& path) {
  const DrawingGraph graph = ReadDrawingJson(path.string()).graph;
  ASSERT_EQ(graph.links.size(), 3u);
  for (size_t link = 0; link < 3; ++link) {
    ASSERT_TRUE(graph.links[link].dense);
    const DenseClass expected = link < 2 ? DenseClass::kSurface : DenseClass::kFree;
    EXPECT_EQ(graph.links[link].dense->dense_class, expected) << link;
    EXPECT_FALSE(graph.links[link].dense->behind_surface) << link;
  }
}

}  // namespace limn::testing
