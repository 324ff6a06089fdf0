// SPDX-License-Identifier: BSD-3-Clause
// drawing_fuser on the sample scene: what dense results gain by the drawing, and whether COLMAP
// reads what is written for it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/dense_files/patch_file.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr char kDay[] = LIMN_SAMPLE_DIR "/day";

// Where the objects are; their true edges are all in it.
const Eigen::AlignedBox3d& Region() {
  static const Eigen::AlignedBox3d box(Eigen::Vector3d(-1.25, -0.95, 0.04),
                                       Eigen::Vector3d(1.25, 0.95, 1.05));
  return box;
}

// Mean distance of the true edges to the surface of a mesh: both sampled, the surface every 5 mm.
double MeanDistanceOfEdges(const fs::path& mesh_path) {
  const TriangleMesh mesh = ReadMesh(mesh_path.string());
  std::vector<Eigen::Vector3d> surface;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d u = mesh.vertices[b] - mesh.vertices[a];
    const Eigen::Vector3d v = mesh.vertices[c] - mesh.vertices[a];
    // Poisson's mesh extends far beyond all points.
    if (Region().exteriorDistance(mesh.vertices[a]) > 0.5) continue;
    const int steps =
        std::clamp(static_cast<int>(std::ceil(std::max(u.norm(), v.norm()) / 0.005)), 1, 100);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        surface.push_back(mesh.vertices[a] + (i * u + j * v) / steps);
      }
    }
  }
  const SpatialIndex index(surface);
  double sum = 0;
  int count = 0;
  for (const Polyline3d& edge : ReadCurves(LIMN_SAMPLE_DIR "/truth/curves-visible.ply").polylines) {
    for (const Eigen::Vector3d& point : ResampleUniform(edge, 0.01)) {
      if (!Region().contains(point)) continue;
      sum += std::sqrt(index.Nearest(point).squared_distance);
      ++count;
    }
  }
  return sum / count;
}

std::string ReadBytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

void MustRun(const std::string& program, const std::vector<std::string>& arguments) {
  const LimnRun run = RunProgram(program, arguments);
  ASSERT_EQ(run.exit_code, 0) << program << " " << arguments.front() << "\n" << run.out << run.err;
}

// The sample scene as a dense workspace with the depth maps that stereo makes, fused by COLMAP, and
// the drawing of the main job. Made once.
class Fusion : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dir_ = new TempDir;
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    MustRun("/usr/bin/python3",
            {LIMN_SOURCE_DIR "/scripts/sample_scene/degrade_depth.py", kDay, Path()});
    MustRun("colmap", {"stereo_fusion", "--workspace_path", Path(), "--workspace_format", "COLMAP",
                       "--input_type", "geometric", "--output_path", Path("fused.ply")});
    MustRun(LIMN_PROGRAM, {"automatic_drawer", "--workspace_path", Path()});
    fused_before_ = ReadBytes(Path("fused.ply"));
    fuser_ = RunLimn({"drawing_fuser", "--workspace_path", Path()});
  }
  static void TearDownTestSuite() { delete dir_; }

  void SetUp() override {
    if (HasFailure()) GTEST_SKIP();
    ASSERT_EQ(fuser_.exit_code, 0) << fuser_.err;
  }

  static std::string Path(const std::string& name = "") { return (*dir_ / name).string(); }

  static TempDir* dir_;
  static LimnRun fuser_;
  static std::string fused_before_;
};

TempDir* Fusion::dir_ = nullptr;
LimnRun Fusion::fuser_;
std::string Fusion::fused_before_;

TEST_F(Fusion, EveryLinkHasAClass) {
  const DrawingFile drawing = ReadDrawingJson(Path("drawing-fused.json"));
  EXPECT_EQ(drawing.graph.links.size(), ReadDrawingJson(Path("drawing.json")).graph.links.size());
  for (const DrawingLink& link : drawing.graph.links) EXPECT_TRUE(link.dense);
  EXPECT_THAT(fuser_.out, HasSubstr("the drawing adds "));
  EXPECT_THAT(fuser_.out, HasSubstr("colmap poisson_mesher --input_path " + Path("with-curves")));
}

TEST_F(Fusion, MeshIsNearerToTheTrueEdgesByAQuarterAtLeast) {
  const auto mesh = [](const std::string& cloud, const std::string& out) {
    MustRun("colmap", {"poisson_mesher", "--input_path", cloud, "--output_path", out,
                       "--PoissonMeshing.depth", "8", "--PoissonMeshing.trim", "5"});
    return MeanDistanceOfEdges(out);
  };
  const double dense_alone = mesh(Path("fused.ply"), Path("dense.ply"));
  const double with_curves = mesh(Path("with-curves/fused.ply"), Path("with-curves.ply"));
  RecordProperty("mean_distance_dense_alone_m", std::to_string(dense_alone));
  RecordProperty("mean_distance_with_curves_m", std::to_string(with_curves));
  EXPECT_LT(with_curves, 0.75 * dense_alone);
}

TEST_F(Fusion, MeshingFolderIsAWorkspaceInColmapsOrder) {
  EXPECT_EQ(ReadBytes(Path("fused.ply")), fused_before_);
  const PlyPointsInfo before = ReadPlyPointsInfo(Path("fused.ply"));
  const PlyPointsInfo after = ReadPlyPointsInfo(Path("with-curves/fused-with-curves.ply"));
  EXPECT_TRUE(after.has_normals);
  EXPECT_GT(after.count, before.count);
  // .vis: the old lists first, byte for byte, and as many as points; numbers of the model's images.
  const std::string old_lists = ReadBytes(Path("fused.ply.vis"));
  const std::string lists = ReadBytes(Path("with-curves/fused.ply.vis"));
  uint64_t count = 0;
  std::memcpy(&count, lists.data(), sizeof(count));
  EXPECT_EQ(count, after.count);
  EXPECT_EQ(lists.substr(8, old_lists.size() - 8), old_lists.substr(8));
  size_t at = 8;
  for (uint64_t p = 0; p < count; ++p) {
    uint32_t num_images = 0;
    ASSERT_LE(at + 4, lists.size());
    std::memcpy(&num_images, lists.data() + at, 4);
    for (uint32_t k = 0; k < num_images; ++k) {
      uint32_t image = 0;
      std::memcpy(&image, lists.data() + at + 4 + 4 * k, 4);
      ASSERT_LT(image, 24u);
    }
    at += 4 + 4 * num_images;
  }
  EXPECT_EQ(at, lists.size());
  EXPECT_TRUE(fs::exists(Path("with-curves/sparse/cameras.bin")));
}

TEST_F(Fusion, ColmapReadsTheSparseModelWithCurves) {
  const colmap_ext::SparseModel before = colmap_ext::ReadModel(Path("sparse"));
  const colmap_ext::SparseModel model = colmap_ext::ReadModel(Path("sparse-with-curves"));
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_GT(model.points.size(), before.points.size() + 1000);
  const LimnRun analyzer =
      RunProgram("colmap", {"model_analyzer", "--path", Path("sparse-with-curves")});
  ASSERT_EQ(analyzer.exit_code, 0);
  EXPECT_THAT(analyzer.out + analyzer.err,
              HasSubstr("Points: " + std::to_string(model.points.size())));
  fs::create_directories(Path("text"));
  MustRun("colmap", {"model_converter", "--input_path", Path("sparse-with-curves"), "--output_path",
                     Path("text"), "--output_type", "TXT"});
  const colmap_ext::SparseModel text = colmap_ext::ReadModel(Path("text"));
  EXPECT_EQ(text.points.size(), model.points.size());
  EXPECT_TRUE(text.warnings.empty());
}

TEST_F(Fusion, AsPmvsPatches) {
  // fused.ply as if it was PMVS's cloud.
  const LimnRun run = RunLimn({"drawing_fuser", "--workspace_path", Path(), "--dense_type", "pmvs",
                               "--dense_path", Path("fused.ply"), "--output_path", Path("pmvs-out"),
                               "--drawing_path", Path("drawing.json")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  size_t num_patches = 0;
  colmap_ext::ReadPatchFile(Path("pmvs-out/pmvs-with-curves.patch"),
                            [&](const colmap_ext::Patch& patch) {
                              EXPECT_NEAR(patch.normal.norm(), 1, 1e-6);
                              EXPECT_FALSE(patch.images.empty());
                              ++num_patches;
                            });
  EXPECT_GT(num_patches, 1000u);
  EXPECT_EQ(ReadPlyPointsInfo(Path("pmvs-out/pmvs-with-curves.ply")).count,
            ReadPlyPointsInfo(Path("fused.ply")).count + num_patches);
}

// Made last: drawing.json is newer then.
TEST_F(Fusion, ClassesSurviveLaterCommands) {
  const LimnRun run =
      RunLimn({"drawing_regularizer", "--workspace_path", Path(), "--overwrite", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const DrawingGraph graph = ReadDrawingJson(Path("drawing.json")).graph;
  const auto num_classes = std::ranges::count_if(
      graph.links, [](const DrawingLink& link) { return link.dense.has_value(); });
  EXPECT_GT(num_classes, static_cast<std::ptrdiff_t>(graph.links.size()) / 2);
}

TEST_F(Fusion, BadInputIsToldInOneLine) {
  const auto refused = [](std::vector<std::string> arguments, const std::string& text) {
    arguments.insert(arguments.begin(),
                     {"drawing_fuser", "--workspace_path", Path(), "--overwrite", "1"});
    const LimnRun run = RunLimn(arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr(text));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  };
  refused({"--dense_type", "laser"}, "dense_type = laser");
  refused({"--dense_path", Path("nowhere")}, "no dense results found");
  refused({"--drawing_path", Path("nowhere.json")}, "nowhere.json");
  refused({"--sparse_spacing_px", "0"}, "sparse_spacing_px");
  dir_->WriteFile("short.ply",
                  "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                  "property float y\nproperty float z\nend_header\n1 2 3\n");
  refused({"--dense_type", "fused", "--dense_path", Path("short.ply")},
          "short.ply: line 9: the file ends too early");
}

}  // namespace
}  // namespace limn::testing
