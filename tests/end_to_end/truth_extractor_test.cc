// SPDX-License-Identifier: BSD-3-Clause
// `limn truth_extractor` on the sample scene's surfaces, and on bad input.
#include <algorithm>
#include <filesystem>
#include <random>
#include <sstream>
#include <tuple>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"
#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/sharp_edges.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_curves_writer.h"
#include "limn/formats/read_curves.h"
#include "support/random_numbers.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const char kMesh[] = LIMN_SAMPLE_DIR "/truth/mesh.ply";
const char kWorkspace[] = LIMN_SAMPLE_DIR "/day";
// A pixel's footprint on the objects, meters (datasets/README.md).
constexpr double kFootprint = 0.005;

class TruthExtractor : public ::testing::Test {
 protected:
  LimnRun Run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "truth_extractor");
    return RunLimn(arguments);
  }

  std::string Output() const { return (dir_ / "out" / "truth.ply").string(); }
  // In a folder that all tests share, and with it the cache of the image curves.
  static std::string SharedOutput(const std::string& name) {
    static const TempDir shared;
    return (shared / name).string();
  }

  void ExpectRefused(const std::vector<std::string>& arguments, const auto& line_matcher) {
    const auto before = ReadTree(dir_.path());
    const LimnRun run = Run(arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), line_matcher));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(ReadTree(dir_.path()), before);
  }

  // With everything that is needed but the source.
  void ExpectSourceRefused(const std::string& option, const std::string& path,
                           const auto& line_matcher) {
    ExpectRefused({option, path, "--workspace_path", kWorkspace, "--output_path", Output(),
                   "--require_edges", "0"},
                  AllOf(HasSubstr(path), line_matcher));
  }

  TempDir dir_;
};

// datasets/README.md.
Eigen::AlignedBox3d RegionOfInterest() {
  return {Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05)};
}

// What surfaces can show of the scene's truth: paint is not in the mesh.
CurveSet TruthOfSurfaces() {
  CurveSet edges;
  edges.polylines = FindSharpEdges(ReadMesh(kMesh), {});
  const CurveSamples surfaces(edges, [](const Polyline3d&) { return 0.01; });
  CurveSet truth;
  for (const Polyline3d& curve :
       ReadCurves(LIMN_SAMPLE_DIR "/truth/curves-visible.ply").polylines) {
    for (const Eigen::Vector3d& point : ResampleUniform(curve, kFootprint)) {
      if (surfaces.Distance(point) < 0.2 * kFootprint) truth.points.push_back(point);
    }
  }
  return truth;
}

// Both truths hold what 4 images show, of which one was made by ray casting and gradients, the
// other by depth images and edgels.
TEST_F(TruthExtractor, AgreesWithTheTruthOfTheSampleScene) {
  const std::string output = SharedOutput("curves.ply");
  const LimnRun run = Run({"--mesh_path", kMesh, "--workspace_path", kWorkspace, "--output_path",
                           output, "--min_views", "4"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("visible in 4 or more images"));
  const CurveSet extracted = ReadCurves(output);
  EvaluationOptions options;
  options.taus = {2 * kFootprint};
  options.region =
      Eigen::AlignedBox3d(Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05));
  const CurveSet all = ReadCurves(LIMN_SAMPLE_DIR "/truth/curves-visible.ply");
  const EvaluationReport precision = EvaluateCurves(extracted, all, options);
  EXPECT_GT(precision.rows.at(0).precision, 0.95);
  const EvaluationReport recall = EvaluateCurves(extracted, TruthOfSurfaces(), options);
  EXPECT_GT(recall.rows.at(0).recall, 0.9);
}

// Two runs; edges are not looked for, so this is quick.
TEST_F(TruthExtractor, SameBytesWhateverTheThreads) {
  for (const char* threads : {"1", "2"}) {
    const LimnRun run = Run({"--mesh_path", kMesh, "--workspace_path", kWorkspace, "--output_path",
                             (dir_ / threads / "truth.ply").string(), "--require_edges", "0",
                             "--num_threads", threads});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  const auto one = ReadTree(dir_ / "1");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one, ReadTree(dir_ / "2"));
}

// A cloud of all surfaces but the ground, points about a pixel apart.
std::vector<Eigen::Vector3d> CloudOfSurfaces() {
  const TriangleMesh mesh = ReadMesh(kMesh);
  std::mt19937 random(1);
  testing::UniformDistribution<double> uniform(0, 1);
  std::vector<Eigen::Vector3d> cloud;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& corner = mesh.vertices[a];
    const Eigen::Vector3d u = mesh.vertices[b] - corner;
    const Eigen::Vector3d v = mesh.vertices[c] - corner;
    const double area = 0.5 * u.cross(v).norm();
    if (area > 100) continue;
    // What is left of a fraction of a point is thrown for.
    const int count = static_cast<int>(area / (kFootprint * kFootprint) + uniform(random));
    for (int i = 0; i < count; ++i) {
      double s = uniform(random);
      double t = uniform(random);
      if (s + t > 1) std::tie(s, t) = std::pair(1 - s, 1 - t);
      cloud.push_back(corner + s * u + t * v);
    }
  }
  return cloud;
}

// Few of the points lie near the truth; those that are kept do. Points may be as far from it as
// edgels may be from them, on a surface seen at a slant.
TEST_F(TruthExtractor, KeepsThePointsOfACloudThatAreOnEdges) {
  CurveSet cloud;
  cloud.points = CloudOfSurfaces();
  std::ostringstream bytes;
  WriteCurvesPly(cloud, bytes);
  const std::string output = SharedOutput("points.ply");
  const LimnRun run = Run({"--cloud_path", dir_.WriteFile("cloud.ply", bytes.str()),
                           "--workspace_path", kWorkspace, "--output_path", output});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const CurveSet kept = ReadCurves(output);
  EXPECT_TRUE(kept.polylines.empty());
  const CurveSet truth = ReadCurves(LIMN_SAMPLE_DIR "/truth/curves-visible.ply");
  EvaluationOptions options;
  options.taus = {3 * kFootprint};
  options.region = RegionOfInterest();
  const CurveSet dont_care = ReadCurves(LIMN_SAMPLE_DIR "/truth/dont-care.ply");
  EXPECT_LT(EvaluateCurves(cloud, truth, options, dont_care).rows.at(0).precision, 0.4);
  const EvaluationReport report = EvaluateCurves(kept, truth, options, dont_care);
  EXPECT_GT(report.rows.at(0).precision, 0.9);
  EXPECT_GT(report.rows.at(0).recall, 0.7);
}

TEST_F(TruthExtractor, OneSourceAndOneOutputFileAreNeeded) {
  ExpectRefused({"--workspace_path", kWorkspace, "--output_path", Output()},
                HasSubstr("mesh_path"));
  ExpectRefused({"--workspace_path", kWorkspace, "--output_path", Output(), "--mesh_path", kMesh,
                 "--cloud_path", kMesh},
                HasSubstr("not both"));
  ExpectRefused({"--workspace_path", kWorkspace, "--mesh_path", kMesh}, HasSubstr("output_path"));
  ExpectRefused({"--workspace_path", kWorkspace, "--mesh_path", kMesh, "--output_path",
                 (dir_ / "truth.obj").string()},
                HasSubstr("truth.obj"));
  ExpectRefused({"--mesh_path", kMesh, "--output_path", Output()}, HasSubstr("workspace_path"));
}

TEST_F(TruthExtractor, BadOptionsAreRefused) {
  for (const auto& [option, value] : {std::pair("min_views", "0"),
                                      {"min_views", "25"},
                                      {"max_distance_px", "0"},
                                      {"min_dihedral_deg", "-3"}}) {
    ExpectRefused({"--mesh_path", kMesh, "--workspace_path", kWorkspace, "--output_path", Output(),
                   "--require_edges", "0", std::string("--") + option, value},
                  HasSubstr(std::string(option) + " = " + value));
  }
}

TEST_F(TruthExtractor, BadSurfacesAndCloudsAreRefused) {
  ExpectSourceRefused("--mesh_path", (dir_ / "absent.ply").string(), HasSubstr("No such file"));
  ExpectSourceRefused("--mesh_path", dir_.WriteFile("0.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"),
                      HasSubstr("no faces"));
  ExpectSourceRefused("--mesh_path", dir_.WriteFile("1.obj", "v 0 0 0\nv 1 nan 0\nf 1 2 3\n"),
                      HasSubstr("line 2: coordinate not finite"));
  ExpectSourceRefused("--mesh_path", dir_.WriteFile("2.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
                      HasSubstr("line 3"));
  ExpectSourceRefused("--cloud_path", LIMN_SAMPLE_DIR "/truth/curves.ply",
                      HasSubstr("has no points"));
}

// A surface that no camera sees leaves nothing to write.
TEST_F(TruthExtractor, NothingShownIsAnError) {
  const std::string far = dir_.WriteFile("far.obj", "v 0 0 900\nv 1 0 900\nv 0 1 900\nf 1 2 3\n");
  ExpectRefused({"--mesh_path", far, "--workspace_path", kWorkspace, "--output_path", Output(),
                 "--require_edges", "0"},
                HasSubstr("shown"));
}

}  // namespace
}  // namespace limn::testing
