// SPDX-License-Identifier: BSD-3-Clause
// drawing_aligner --apply_to project: a whole workspace in the world, all of its files in one
// frame.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/test_database.h"
#include "end_to_end/fusion_scene.h"
#include "end_to_end/limn_process.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/tmp_fs.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

// A drawing of the sample scene's first images, drawn once.
const std::string& DrawnSample() {
  static const TempDir dir;
  static const std::string path = [] {
    const LimnRun run = RunLimn({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                                 "--output_path", (dir / "out").string(), "--quality", "low",
                                 "--max_image_size", "320", "--num_threads", "2", "--page", "0"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return (dir / "out/drawing.json").string();
  }();
  return path;
}

std::vector<Eigen::Vector3d> PointsOf(const fs::path& path) {
  std::vector<Eigen::Vector3d> points;
  ReadPlyPoints(path.string(), [&](const PlyPoint& point) { points.push_back(point.position); });
  return points;
}

std::vector<Eigen::Vector3d> PointsOf(const DrawingGraph& graph) {
  std::vector<Eigen::Vector3d> points;
  for (const DrawingNode& node : graph.nodes) points.push_back(node.position_in_world);
  for (const DrawingLink& link : graph.links) {
    points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
  }
  return points;
}

std::vector<Eigen::Vector3d> CurvePointsOf(const fs::path& path) {
  std::vector<Eigen::Vector3d> points;
  for (const Polyline3d& curve : ReadCurves(path.string()).polylines) {
    points.insert(points.end(), curve.begin(), curve.end());
  }
  return points;
}

std::vector<Eigen::Vector3d> PointsOf(const colmap_ext::SparseModel& model) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& point : model.points) points.push_back(point.position);
  for (const auto& image : model.images) {
    points.push_back(Inverse(image.cam_from_world).translation);
  }
  return points;
}

// `moved` are `points`, moved, to within a millionth of the extent of the scene, of some units.
void ExpectMoved(const std::vector<Eigen::Vector3d>& points,
                 const std::vector<Eigen::Vector3d>& moved, const Similarity3d& similarity) {
  ASSERT_EQ(points.size(), moved.size());
  ASSERT_FALSE(points.empty());
  double farthest = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d expected =
        similarity.scale * (similarity.rotation * points[i]) + similarity.translation;
    farthest = std::max(farthest, (moved[i] - expected).norm());
  }
  EXPECT_LT(farthest, 1e-6 * similarity.scale * 5);
}

class AlignedProject : public ::testing::Test {
 protected:
  // A dense workspace with links to the images, as `image_undistorter --copy_policy` makes them.
  AlignedProject() {
    fs::copy(LIMN_SAMPLE_DIR "/day/sparse", Path("sparse"));
    fs::create_directory_symlink(LIMN_SAMPLE_DIR "/day/images", Path("images"));
    fs::copy(DrawnSample(), Path("drawing.json"));
    fs::create_directories(Path("stereo/depth_maps"));
    fs::create_directories(Path("pmvs/models"));
    dir_.WriteFile("pmvs/models/option-0000.ply", PlanePly({}));
    dir_.WriteFile("fused.ply", PlanePly({}));
    std::string lists(8, '\0');
    const uint64_t count = PlanePoints().size();
    lists.replace(0, 8, reinterpret_cast<const char*>(&count), 8);
    for (uint64_t i = 0; i < count; ++i) lists += std::string("\1\0\0\0\2\0\0\0", 8);
    dir_.WriteFile("fused.ply.vis", lists);
    dir_.WriteFile("meshed-poisson.ply", PlaneMesh());
    dir_.WriteFile("meshed-delaunay.ply", PlaneMesh(Eigen::Vector3d(0, 0, 0.5)));
  }

  fs::path Path(const std::string& name) const { return dir_ / name; }
  fs::path Aligned(const std::string& name = "") const { return Path("aligned") / name; }

  std::vector<std::string> Arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"drawing_aligner",
                                          "--workspace_path",
                                          dir_.path().string(),
                                          "--max_image_size",
                                          "320",
                                          "--num_threads",
                                          "2",
                                          "--apply_to",
                                          "project",
                                          "--known_length",
                                          "link 0 = 2.40 m"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  LimnRun Align(const std::vector<std::string>& more = {}) const {
    return RunLimn(Arguments(more));
  }

  Similarity3d WorldFromModel() const {
    return ReadDrawingJson(Path("drawing.json").string()).metadata.alignment->world_from_model;
  }

  // All files of the folder are those of the workspace, moved by one similarity.
  void ExpectAllMoved(const Similarity3d& similarity) const {
    ExpectMoved(PointsOf(colmap_ext::ReadModel(Path("sparse"))),
                PointsOf(colmap_ext::ReadModel(Aligned("sparse"))), similarity);
    ExpectMoved(PointsOf(Path("fused.ply")), PointsOf(Aligned("fused.ply")), similarity);
    for (const char* mesh : {"meshed-poisson.ply", "meshed-delaunay.ply"}) {
      ExpectMoved(ReadMesh(Path(mesh).string()).vertices, ReadMesh(Aligned(mesh).string()).vertices,
                  similarity);
    }
    const DrawingGraph graph = ReadDrawingJson(Path("drawing.json").string()).graph;
    ExpectMoved(PointsOf(graph), PointsOf(ReadDrawingJson(Aligned("drawing.json").string()).graph),
                similarity);
    const DrawingGraph shown = Selected(graph, LinkSelection());
    std::vector<Eigen::Vector3d> points;
    for (const DrawingLink& link : shown.links) {
      points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
    }
    ExpectMoved(points, CurvePointsOf(Aligned("drawing.ply")), similarity);
    ExpectMoved(points, CurvePointsOf(Aligned("drawing.obj")), similarity);
  }

  void ExpectNothingLeft() const {
    for (const auto& entry : fs::directory_iterator(dir_.path())) {
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("limn-tmp")));
    }
  }

  TempDir dir_;
};

TEST_F(AlignedProject, AllOfItIsInOneWorld) {
  const auto before = ReadTree(dir_.path());
  const LimnRun run = Align();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Similarity3d world_from_model = WorldFromModel();
  EXPECT_GT(std::abs(world_from_model.scale - 1), 0.01);
  ExpectAllMoved(world_from_model);

  const auto files = ReadTree(Aligned());
  EXPECT_EQ(files.at("fused.ply.vis"), before.at("fused.ply.vis"));
  EXPECT_EQ(files.at("sparse/cameras.bin"), before.at("sparse/cameras.bin"));
  EXPECT_FALSE(files.contains("offset.txt"));
  EXPECT_EQ(files.contains("drawing.html"), HasViewerPage());
  EXPECT_FALSE(fs::exists(Aligned("stereo")));
  EXPECT_THAT(run.out + run.err,
              AllOf(HasSubstr("stereo is left out: depth maps are in the unit of the model"),
                    HasSubstr("pmvs/models is left out"),
                    HasSubstr("Written: " + Aligned().parent_path().string())));
  EXPECT_EQ(fs::canonical(Aligned("images")), fs::canonical(Path("images")));
  EXPECT_TRUE(fs::read_symlink(Aligned("images")).is_relative());
  // It says of itself that it is in the world, where its scale is from, and that it fits the model.
  const DrawingMetadata metadata = ReadDrawingJson(Aligned("drawing.json").string()).metadata;
  ASSERT_TRUE(metadata.alignment);
  EXPECT_EQ(metadata.alignment->scale, ScaleSource::kLengths);
  EXPECT_EQ(metadata.alignment->world_from_model.scale, 1);
  EXPECT_EQ(metadata.alignment->world_from_model.translation, Eigen::Vector3d(0, 0, 0));
  // Normals are turned, and colors are what they were.
  ReadPlyPoints(Aligned("fused.ply").string(), [&](const PlyPoint& point) {
    EXPECT_LT((point.normal - world_from_model.rotation.col(2)).norm(), 1e-6);
    EXPECT_EQ(point.color[0], '\t');
  });
  // The workspace itself has got nothing but the alignment.
  auto after = ReadTree(dir_.path());
  std::erase_if(after, [](const auto& file) { return file.first.starts_with("aligned/"); });
  after["drawing.json"] = before.at("drawing.json");
  EXPECT_TRUE(after == before);
  ExpectNothingLeft();
}

TEST_F(AlignedProject, LimnOpensItAgain) {
  ASSERT_EQ(Align().exit_code, 0);
  const std::string folder = (dir_ / "aligned").string();
  const LimnRun run = RunLimn({"drawing_aligner", "--workspace_path", folder, "--max_image_size",
                               "320", "--known_length", "link 0 = 2.40 m", "--num_threads", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("Model " + Aligned("sparse").string() + " (24 registered"),
                             HasSubstr("drawing: " + Aligned("drawing.json").string())));
  // It stands upright and to scale already.
  const Similarity3d again =
      ReadDrawingJson(Aligned("drawing.json").string()).metadata.alignment->world_from_model;
  EXPECT_NEAR(again.scale, 1, 1e-9);
  EXPECT_LT((again.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-6);
  const LimnRun fuser = RunLimn({"drawing_fuser", "--workspace_path", folder, "--max_image_size",
                                 "320", "--num_threads", "2"});
  EXPECT_EQ(fuser.exit_code, 0) << fuser.err;
  EXPECT_THAT(fuser.out, HasSubstr("dense results: fused, " + Aligned("fused.ply").string()));
}

TEST_F(AlignedProject, ColmapOpensIt) {
  if (!colmap_ext::HaveColmap()) GTEST_SKIP() << "colmap is not installed";
  ASSERT_EQ(Align().exit_code, 0);
  ASSERT_TRUE(
      colmap_ext::RunColmap("model_analyzer --path " + Aligned("sparse").string(), Path("log")));
  const auto model = colmap_ext::ReadModel(Path("sparse"));
  EXPECT_THAT(ReadTree(dir_.path()).at("log"),
              AllOf(HasSubstr("Points: " + std::to_string(model.points.size())),
                    HasSubstr("Registered images: 24")));
  // It finds the images, too, and reads the cloud.
  EXPECT_TRUE(colmap_ext::RunColmap("image_undistorter --image_path " + Aligned("images").string() +
                                        " --input_path " + Aligned("sparse").string() +
                                        " --output_path " + Path("undistorted").string(),
                                    Path("log")));
  EXPECT_TRUE(fs::exists(Path("undistorted/images/view_00.jpg")));
  EXPECT_TRUE(colmap_ext::RunColmap("poisson_mesher --input_path " + Aligned("fused.ply").string() +
                                        " --output_path " + Path("mesh.ply").string() +
                                        " --PoissonMeshing.depth 5 --PoissonMeshing.trim 0",
                                    Path("log")));
}

// Positions in a national grid, millions of meters from its origin.
TEST_F(AlignedProject, LargeCoordinatesKeepTheirMillimeters) {
  const Similarity3d grid = {20,
                             Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
                             {2600012.345, 1199987.654, 391.5}};
  std::vector<StoredPrior> priors;
  for (const auto& image : colmap_ext::ReadModel(Path("sparse")).images) {
    const Eigen::Vector3d center = Inverse(image.cam_from_world).translation;
    priors.push_back({image.name, grid * center, 1});
  }
  WriteDatabase(Path("database.db"), DatabaseVersion::k4_1, priors);
  std::vector<std::string> arguments = Arguments({"--world", "positions"});
  std::erase(arguments, "--known_length");
  std::erase(arguments, "link 0 = 2.40 m");
  const LimnRun run = RunLimn(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Similarity3d world_from_model = WorldFromModel();
  EXPECT_NEAR(world_from_model.scale, grid.scale, 1e-6);
  EXPECT_LT((world_from_model.rotation - grid.rotation).norm(), 1e-6);
  EXPECT_LT((world_from_model.translation - grid.translation).norm(), 1e-5);

  const Eigen::Vector3d offset(2600000, 1200000, 400);
  const auto files = ReadTree(Aligned());
  EXPECT_THAT(files.at("offset.txt"), ::testing::EndsWith("\n2600000 1200000 400\n"));
  EXPECT_THAT(run.out, HasSubstr("relative to 2600000 1200000 400"));
  for (const char* name : {"fused.ply", "meshed-poisson.ply", "meshed-delaunay.ply"}) {
    EXPECT_THAT(files.at(name).substr(0, 200), HasSubstr("\ncomment offset 2600000 1200000 400\n"));
  }
  Similarity3d frame_from_model = world_from_model;
  frame_from_model.translation -= offset;
  ExpectAllMoved(frame_from_model);
  const auto alignment = ReadDrawingJson(Aligned("drawing.json").string()).metadata.alignment;
  EXPECT_EQ(alignment->world_from_model.translation, offset);
  // A tenth of a millimeter in every format.
  double farthest = 0;
  for (const Eigen::Vector3d& point : PointsOf(Aligned("fused.ply"))) {
    farthest = std::max(farthest, std::abs((point + offset - grid.translation).z()));
  }
  EXPECT_LT(farthest, 1e-4);
}

TEST_F(AlignedProject, AWorldOfPositionsNeedsThem) {
  LimnRun run = Align({"--world", "positions"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("database.db: has no positions that tell where the drawing is"));
  run = Align({"--world", "positions", "--use_positions", "0"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("use_positions = 0"));
  EXPECT_FALSE(fs::exists(Aligned()));
}

TEST_F(AlignedProject, OnlyWhatLimnHasMadeIsReplaced) {
  const auto refuses = [&](const std::string& reason, const std::vector<std::string>& more = {}) {
    const auto before = ReadTree(dir_.path());
    const LimnRun run = Align(more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(::testing::StartsWith("ERROR: " + dir_.path().string() + "/aligned"),
                               HasSubstr(reason)));
    EXPECT_TRUE(ReadTree(dir_.path()) == before) << reason;
  };
  dir_.WriteFile("aligned/notes.txt", "mine");
  refuses("notes.txt: was not made by drawing_aligner", {"--overwrite", "1"});
  fs::remove_all(Aligned());
  dir_.WriteFile("aligned/fused.ply", "mine");
  refuses("aligned: exists, and was not made by limn", {"--overwrite", "1"});
  fs::remove_all(Aligned());
  dir_.WriteFile("aligned", "mine");
  refuses("aligned: is not a folder", {"--overwrite", "1"});
  fs::remove(Path("aligned"));
  const TempDir elsewhere;
  fs::create_directory_symlink(elsewhere.path(), Path("aligned"));
  refuses("aligned: is a link to", {"--overwrite", "1"});
  fs::remove(Path("aligned"));

  fs::create_directory(Path("aligned"));
  ASSERT_EQ(Align().exit_code, 0);
  refuses("aligned: exists: --overwrite 1 replaces it");
  refuses("in it is read: choose another --output_path",
          {"--input_path", Aligned("sparse").string(), "--image_path", Aligned("images").string(),
           "--output_path", dir_.path().string(), "--overwrite", "1"});
  dir_.WriteFile("aligned/sparse/notes.txt", "mine");
  refuses("sparse: was not made by drawing_aligner", {"--overwrite", "1"});
  fs::remove(Aligned("sparse/notes.txt"));
  fs::remove(Path("meshed-poisson.ply"));
  const LimnRun run = Align({"--overwrite", "1"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(fs::exists(Aligned("meshed-poisson.ply")));
  EXPECT_TRUE(fs::exists(Aligned("meshed-delaunay.ply")));
  EXPECT_TRUE(fs::exists(Path("images/view_00.jpg")));
  ExpectNothingLeft();
}

TEST_F(AlignedProject, DamagedCloudsAndMeshesAreLeftOut) {
  std::string cloud = PlanePly({.ascii = true});
  cloud.replace(cloud.rfind("1.6 1.6"), 3, "nan");
  dir_.WriteFile("fused.ply", cloud);
  const std::string mesh = PlaneMesh();
  dir_.WriteFile("meshed-poisson.ply", mesh.substr(0, mesh.size() - 6));
  fs::remove(Path("meshed-delaunay.ply"));
  fs::create_symlink("nowhere", Path("meshed-delaunay.ply"));
  const LimnRun run = Align();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* name :
       {"fused.ply: line", "meshed-poisson.ply: line", "meshed-delaunay.ply: "}) {
    EXPECT_THAT(run.out + run.err, HasSubstr("WARNING: " + Path(name).string()));
  }
  EXPECT_THAT(run.out + run.err, HasSubstr("coordinate not finite: left out"));
  for (const char* name :
       {"fused.ply", "fused.ply.vis", "meshed-poisson.ply", "meshed-delaunay.ply"}) {
    EXPECT_FALSE(fs::exists(Aligned(name))) << name;
  }
  EXPECT_TRUE(fs::exists(Aligned("drawing.json")));

  dir_.WriteFile("fused.ply", PlanePly({}));
  dir_.WriteFile("fused.ply.vis", std::string(8, '\0'));
  const LimnRun again = Align({"--overwrite", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out + again.err, HasSubstr("fused.ply.vis: 0 points, but the cloud has"));
  EXPECT_TRUE(fs::exists(Aligned("fused.ply")));
  EXPECT_FALSE(fs::exists(Aligned("fused.ply.vis")));
}

// Newer versions of COLMAP have a rig for every camera, and text is text.
TEST_F(AlignedProject, TheModelKeepsItsForm) {
  auto model = colmap_ext::ReadModel(Path("sparse"));
  for (const auto& camera : model.cameras) {
    model.rigs.push_back({camera.id, {{{0, camera.id}, true, {}}}});
  }
  for (const auto& image : model.images) {
    model.frames.push_back(
        {image.id, image.camera_id, image.cam_from_world, {{{0, image.camera_id}, image.id}}});
  }
  fs::remove_all(Path("sparse"));
  colmap_ext::WriteModelText(model, Path("sparse"));
  ASSERT_EQ(Align().exit_code, 0);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : ReadTree(Aligned("sparse"))) names.push_back(name);
  EXPECT_THAT(names, UnorderedElementsAre("cameras.txt", "images.txt", "points3D.txt", "rigs.txt",
                                          "frames.txt"));
  const auto aligned = colmap_ext::ReadModel(Aligned("sparse"));
  EXPECT_THAT(aligned.warnings, ::testing::IsEmpty());
  EXPECT_EQ(aligned.frames.size(), model.frames.size());
  ExpectAllMoved(WorldFromModel());
}

TEST_F(AlignedProject, AFullDiskIsAnErrorThatNamesTheFile) {
  // Enough to store the alignment.
  const TmpFs disk(Path("out"), 2 * fs::file_size(DrawnSample()) + 100'000);
  if (!disk.is_mounted()) GTEST_SKIP() << "needs root";
  fs::copy(DrawnSample(), Path("out/drawing.json"));
  const LimnRun run = Align({"--output_path", Path("out").string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("aligned.limn-tmp/"), HasSubstr("No space left")));
  EXPECT_FALSE(fs::exists(Path("out/aligned")));
  EXPECT_FALSE(fs::exists(Path("out/aligned.limn-tmp")));
}

TEST_F(AlignedProject, AStopLeavesNothing) {
  std::string mesh = PlaneMesh();
  const size_t end = mesh.find("4\n");
  mesh.replace(end, 1, "3000000");
  std::string rows;
  for (int i = 0; i < 3'000'000; ++i) rows += "0.125 0.25 0.375\n";
  mesh.replace(mesh.find("-2"), mesh.find("4 0 1") - mesh.find("-2"), rows);
  dir_.WriteFile("meshed-poisson.ply", mesh);
  for (const int signal : {SIGINT, SIGTERM}) {
    LimnProcess run(Arguments());
    run.WaitUntil([&] { return fs::exists(Path("aligned.limn-tmp/sparse")); });
    run.Signal(signal);
    const LimnProcess::End stopped = run.Wait();
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_LT(stopped.seconds, 2);
    EXPECT_FALSE(fs::exists(Path("aligned")));
    ExpectNothingLeft();
  }
  LimnProcess killed(Arguments());
  killed.WaitUntil([&] { return fs::exists(Path("aligned.limn-tmp/sparse")); });
  killed.Signal(SIGKILL);
  killed.Wait();
  fs::remove(Path("meshed-poisson.ply"));
  EXPECT_EQ(Align().exit_code, 0);
  ExpectNothingLeft();
}

}  // namespace
}  // namespace limn::testing
