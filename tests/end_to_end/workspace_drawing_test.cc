// SPDX-License-Identifier: BSD-3-Clause
// Commands that are given a workspace find its drawing; the drawing goes to LIMAP and back.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/limap_structures.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/similarity3.h"
#include "limn/model/drawing_transform.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A workspace of the sample's images whose drawing has a line and a bent link that continues it.
class WorkspaceDrawing : public ::testing::Test {
 protected:
  WorkspaceDrawing() {
    for (const char* name : {"images", "sparse"}) {
      fs::create_directory_symlink(fs::path(LIMN_SAMPLE_DIR "/day") / name, dir_ / name);
    }
    for (const auto& image : colmap_ext::ReadColmapModel(dir_ / "sparse").images) {
      drawing_.metadata.view_names.push_back(image.name);
    }
    std::sort(drawing_.metadata.view_names.begin(), drawing_.metadata.view_names.end());
    DrawingGraph& graph = drawing_.graph;
    graph.nodes.resize(3);
    graph.nodes[1].position_in_world = {0.5, 0, 0.5};
    graph.nodes[2].position_in_world = {0.5, 0.75, 0.5};
    graph.links.resize(2);
    graph.links[0].points_in_world = {{0, 0, 0}, {0.5, 0, 0.5}};
    graph.links[1].points_in_world = {{0.5, 0, 0.5}, {0.75, 0.25, 0.5}, {0.5, 0.75, 0.5}};
    for (const int id : {0, 1}) {
      graph.links[id].node0 = id;
      graph.links[id].node1 = id + 1;
      graph.links[id].sigma.assign(graph.links[id].size(), 0.01);
      graph.links[id].supporting_views = {0, 1, 2, 3, 4};
    }
    RebuildIncidence(&graph);
  }

  void Store(const std::string& name) {
    WriteDrawing((dir_ / name).string(), drawing_.graph, drawing_.metadata);
  }

  LimnRun Run(const std::string& command, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {command, "--workspace_path", dir_.path().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  std::string Path(const std::string& name) const { return (dir_ / name).string(); }

  TempDir dir_;
  DrawingFile drawing_;
};

TEST_F(WorkspaceDrawing, IsFoundByCommandsThatUseIt) {
  Store("drawing.json");
  const LimnRun exported = Run("drawing_exporter", {"--output_path", Path("a.json")});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_THAT(exported.out, HasSubstr("drawing: " + Path("drawing.json") + "\n"));
  EXPECT_EQ(ReadDrawingJson(Path("a.json")).graph.links.size(), 2u);
  const LimnRun judged =
      Run("drawing_evaluator", {"--truth_path", Path("a.json"), "--taus", "0.01"});
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("drawing: " + Path("drawing.json") + "\n"));
}

TEST_F(WorkspaceDrawing, OfTheDenseWorkspaceComesFirst) {
  fs::create_directories(dir_ / "dense");
  fs::rename(dir_ / "images", dir_ / "dense/images");
  fs::rename(dir_ / "sparse", dir_ / "dense/sparse");
  Store("drawing.json");
  EXPECT_THAT(Run("drawing_exporter", {"--output_path", Path("a.obj")}).out,
              HasSubstr("drawing: " + Path("drawing.json") + "\n"));
  Store("dense/drawing.json");
  Store("dense/drawing-fused.json");
  EXPECT_THAT(Run("drawing_exporter", {"--output_path", Path("b.obj")}).out,
              HasSubstr("drawing: " + Path("dense/drawing-fused.json") + "\n"));
  // A path that is given is the one.
  EXPECT_EQ(Run("drawing_exporter",
                {"--output_path", Path("c.obj"), "--input_path", Path("drawing.json")})
                .out,
            "Written: " + Path("c.obj") + " (2 links)\n");
}

TEST_F(WorkspaceDrawing, MissingItIsNamedByEveryCommand) {
  const std::string w = dir_.path().string();
  const auto expect_refused = [&](const std::string& command, const std::vector<std::string>& more,
                                  const std::string& names, const std::string& option) {
    const LimnRun run = Run(command, more);
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_EQ(run.err, "ERROR: " + w + ": no " + names + " (looked in " + w +
                           "): draw one first, or name one with --" + option + "\n");
  };
  const std::string both = "drawing.json or drawing-fused.json";
  expect_refused("drawing_exporter", {"--output_path", Path("a.obj")}, both, "input_path");
  expect_refused("drawing_evaluator", {"--truth_path", Path("a.obj"), "--taus", "1"}, both,
                 "input_path");
  expect_refused("drawing_viewer", {}, both, "drawing_path");
  expect_refused("drawing_aligner", {}, both, "drawing_path");
  expect_refused("drawing_refiner", {}, "drawing.json", "drawing_path");
  expect_refused("drawing_surfacer", {}, "drawing.json", "drawing_path");
  expect_refused("drawing_fuser", {}, "drawing.json", "drawing_path");
  const LimnRun nothing = RunLimn({"drawing_exporter", "--output_path", Path("a.obj")});
  EXPECT_EQ(nothing.err, "ERROR: --input_path or --workspace_path must be given\n");
}

// An output folder without a model is a workspace, too, for what needs none.
TEST_F(WorkspaceDrawing, IsFoundInAFolderOfResults) {
  fs::create_directories(dir_ / "results");
  Store("results/drawing.json");
  const LimnRun run = RunLimn(
      {"drawing_exporter", "--workspace_path", Path("results"), "--output_path", Path("a.dxf")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

// A model that cannot be used is none that was meant: its drawing is elsewhere.
TEST_F(WorkspaceDrawing, OfAnotherModelThanAskedForIsNotTaken) {
  Store("drawing.json");
  const auto error_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--output_path", Path("a.obj")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run("drawing_exporter", arguments).err;
  };
  EXPECT_EQ(error_of({}), "");
  fs::remove(dir_ / "a.obj");
  EXPECT_THAT(error_of({"--model_index", "7"}),
              HasSubstr("no COLMAP model with its images with model_index 7"));
  EXPECT_THAT(error_of({"--image_path", Path("nowhere")}), HasSubstr("nowhere: no such folder"));
  fs::remove(dir_ / "images");
  EXPECT_THAT(error_of({}), HasSubstr("no COLMAP model with its images"));
  fs::remove(dir_ / "sparse");
  EXPECT_THAT(error_of({"--model_index", "7"}), HasSubstr("with model_index 7"));
  EXPECT_FALSE(fs::exists(dir_ / "a.obj"));
  EXPECT_EQ(error_of({}), "");
}

TEST_F(WorkspaceDrawing, ObjOfSegments) {
  Store("drawing.json");
  ASSERT_EQ(Run("drawing_exporter", {"--output_path", Path("a.obj"), "--segments", "1"}).exit_code,
            0);
  EXPECT_THAT(ReadTree(dir_.path()).at("a.obj"), HasSubstr("\nl 2 4\nl 4 3\n"));
}

TEST_F(WorkspaceDrawing, GoesToLimapAndBack) {
  Store("drawing.json");
  const LimnRun made = Run("drawing_exporter", {"--output_path", Path("limap"), "--output_type",
                                                "limap", "--chains", "1"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("3 lines, 4 ends where lines meet"));
  const colmap_ext::SparseModel model = colmap_ext::ReadColmapModel(dir_ / "limap");
  EXPECT_TRUE(model.warnings.empty());
  const LimapStructures structures = ReadLimapStructures(dir_ / "limap/structures");
  ASSERT_EQ(structures.images.size(), model.images.size());
  for (const LimapImage& image : structures.images) {
    const auto of_model = std::find_if(model.images.begin(), model.images.end(),
                                       [&](const auto& other) { return other.id == image.id; });
    ASSERT_NE(of_model, model.images.end());
    EXPECT_EQ(image.num_points, of_model->observations.size());
  }
  // Its lines are curves, and a drawing for the other commands.
  const LimnRun judged = RunLimn({"drawing_evaluator", "--input_path", Path("limap"),
                                  "--truth_path", Path("drawing.json"), "--taus", "0.001"});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  // Of a kind, too, which bare lines have not.
  const LimnRun of_kind =
      RunLimn({"drawing_evaluator", "--input_path", Path("limap"), "--kinds", "paint",
               "--truth_path", Path("drawing.json"), "--taus", "0.001"});
  EXPECT_EQ(of_kind.exit_code, 0) << of_kind.err;
  EXPECT_NE(of_kind.out, judged.out);
  ASSERT_EQ(
      Run("drawing_exporter", {"--input_path", Path("limap"), "--output_path", Path("back.json")})
          .exit_code,
      0);
  const DrawingFile back = ReadDrawingJson(Path("back.json"));
  EXPECT_EQ(back.metadata.view_names, drawing_.metadata.view_names);
  ASSERT_EQ(back.graph.links.size(), 3u);
  EXPECT_EQ(back.graph.nodes.size(), 4u);
  EXPECT_EQ(back.graph.links[0].points_in_world, drawing_.graph.links[0].points_in_world);
  EXPECT_EQ(back.graph.links[0].node1, back.graph.links[1].node0);
  // Also where the project leaves images out.
  const std::string list = dir_.WriteFile("list.txt", "view_01.jpg\nview_02.jpg\nview_07.jpg\n");
  if (HasViewerPage()) {
    const LimnRun seen =
        Run("drawing_viewer", {"--drawing_path", Path("limap"), "--image_list_path", list,
                               "--output_path", Path("page")});
    EXPECT_EQ(seen.exit_code, 0) << seen.err;
    EXPECT_THAT(seen.out, HasSubstr("3 links, 3 photographs"));
  }
  // Without chains the bent link stays behind.
  EXPECT_THAT(
      Run("drawing_exporter", {"--output_path", Path("lines"), "--output_type", "limap"}).out,
      HasSubstr("lines (1 links)\n"));
  // Nothing is overwritten, and a failure leaves nothing.
  const LimnRun again =
      Run("drawing_exporter", {"--output_path", Path("limap"), "--output_type", "limap"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("holds a model already"));
  EXPECT_THAT(Run("drawing_exporter",
                  {"--output_path", Path("l2"), "--output_type", "limap", "--scale", "2"})
                  .err,
              HasSubstr("a model keeps its coordinates"));
  EXPECT_FALSE(fs::exists(dir_ / "l2"));
}

TEST_F(WorkspaceDrawing, GoesToColmapAsPoints) {
  Store("drawing.json");
  const auto run = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--output_path", Path(folder), "--output_type", "colmap"};
    options.insert(options.end(), more.begin(), more.end());
    return Run("drawing_exporter", options);
  };
  const LimnRun made = run("curves", {});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr(" points of curves beside "));
  const colmap_ext::SparseModel before = colmap_ext::ReadColmapModel(dir_ / "sparse");
  const colmap_ext::SparseModel model = colmap_ext::ReadColmapModel(dir_ / "curves");
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_EQ(model.images.size(), before.images.size());
  EXPECT_GT(model.points.size(), before.points.size() + 20);
  // COLMAP's viewers show points of three or more images.
  for (size_t p = before.points.size(); p < model.points.size(); ++p) {
    ASSERT_GE(model.points[p].track.size(), 3u);
  }
  ASSERT_EQ(run("dotted", {"--point_spacing_px", "20"}).exit_code, 0);
  EXPECT_LT(colmap_ext::ReadColmapModel(dir_ / "dotted").points.size() - before.points.size(),
            (model.points.size() - before.points.size()) / 5);
  EXPECT_THAT(run("curves", {}).err, HasSubstr("holds a model already"));
  EXPECT_THAT(run("c2", {"--aligned", "1"}).err, HasSubstr("a model keeps its coordinates"));
  EXPECT_THAT(run("c2", {"--point_spacing_px", "0"}).err, HasSubstr("point_spacing_px"));
  EXPECT_FALSE(fs::exists(dir_ / "c2"));
}

// A square of 0.4 above the objects, and beside it the same once more.
constexpr char kTwoSquares[] =
    "v 0 0 1.2\nv 0.4 0 1.2\nv 0.4 0.4 1.2\nv 0 0.4 1.2\nv 0.4 0 1.2\nv 0.8 0 1.2\n"
    "v 0.8 0.4 1.2\nv 0.4 0.4 1.2\nf 1 2 3 4\nf 5 6 7 8\n";

DrawingFace FirstSquare() {
  DrawingFace face;
  face.vertices = {{0, 0, 1.2}, {0.4, 0, 1.2}, {0.4, 0.4, 1.2}, {0, 0.4, 1.2}};
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  face.offset = 1.2;
  for (int k = 0; k < 4; ++k) {
    face.loops.resize(1);
    face.loops[0].push_back({-1, 0, 0, {face.vertices[k], face.vertices[(k + 1) % 4]}});
  }
  return face;
}

TEST_F(WorkspaceDrawing, ItsFacesAreJudgedByATrueSurface) {
  drawing_.graph.faces = {FirstSquare()};
  Store("drawing.json");
  const std::string truth = dir_.WriteFile("truth.obj", kTwoSquares);
  const LimnRun judged = Run("drawing_evaluator", {"--truth_mesh_path", truth, "--Faces.taus",
                                                   "0.5,2", "--output_csv", Path("faces.csv")});
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("faces 1, area 0.16;"));
  EXPECT_THAT(judged.out, HasSubstr("2 rho      100.0       5"));  // half of the truth and 2 px
  EXPECT_TRUE(fs::exists(Path("faces.csv")));
  // Together with its curves, and of a mesh instead, for which no drawing is needed.
  const LimnRun with_curves = Run("drawing_evaluator", {"--truth_mesh_path", truth, "--truth_path",
                                                        Path("drawing.json"), "--taus", "0.01"});
  EXPECT_THAT(with_curves.out, HasSubstr("links 2"));
  EXPECT_THAT(with_curves.out, HasSubstr("faces 1, area 0.16;"));
  fs::remove(Path("drawing.json"));
  const LimnRun of_mesh =
      Run("drawing_evaluator", {"--truth_mesh_path", truth, "--mesh_path", truth});
  ASSERT_EQ(of_mesh.exit_code, 0) << of_mesh.err;
  EXPECT_THAT(of_mesh.out, HasSubstr("2 rho      100.0      100.0      100.0"));
}

// A rod of radius 0.02 and the outlines that it stands for, with nodes of their own.
void AddRodWithOutlines(DrawingGraph* graph) {
  for (const double y : {1.0, 0.98, 1.02}) {
    DrawingLink link;
    link.points_in_world = {{0, y, 0.5}, {1, y, 0.5}};
    link.sigma = {0.01, 0.01};
    link.node0 = static_cast<NodeId>(graph->nodes.size());
    link.node1 = link.node0 + 1;
    const bool is_rod = y == 1;
    link.kind = is_rod ? LinkKind::kRod : LinkKind::kEdge;
    link.rod_radius = is_rod ? 0.02 : 0;
    link.tentative = !is_rod;
    link.doubt = is_rod ? LinkDoubt::kNone : LinkDoubt::kRodOutline;
    for (const Eigen::Vector3d& end : link.points_in_world) {
      graph->nodes.emplace_back();
      graph->nodes.back().position_in_world = end;
    }
    graph->links.push_back(link);
  }
  RebuildIncidence(graph);
}

TEST_F(WorkspaceDrawing, ItsRodsAreJudgedByTrueCenterLinesOrByTheirOutlines) {
  AddRodWithOutlines(&drawing_.graph);
  Store("drawing.json");
  const std::string truth =
      dir_.WriteFile("truth.obj",
                     "v 0 0 0\nv 0.5 0 0.5\nl 1 2\nv 0.75 0.25 0.5\nv 0.5 0.75 0.5\nl 2 3 4\n"
                     "v 0 0.98 0.5\nv 1 0.98 0.5\nl 5 6\nv 0 1.02 0.5\nv 1 1.02 0.5\nl 7 8\n");
  const std::string rods = dir_.WriteFile("rods.obj", "v 0 1 0.5\nv 1 1 0.5\nl 1 2\n");
  const std::vector<std::string> by_outlines = {"--truth_path", truth, "--taus", "0.01"};
  const LimnRun as_seen = Run("drawing_evaluator", by_outlines);
  ASSERT_EQ(as_seen.exit_code, 0) << as_seen.err;
  EXPECT_THAT(as_seen.out, HasSubstr(" 0.01      100.0      100.0      100.0"));
  EXPECT_THAT(as_seen.out, HasSubstr("\nlinks 4,"));
  EXPECT_THAT(as_seen.out, Not(HasSubstr("told as rods")));
  std::vector<std::string> more = by_outlines;
  more.insert(more.end(), {"--rods_as_outlines", "0"});
  EXPECT_THAT(Run("drawing_evaluator", more).out, HasSubstr("\nlinks 3,"));
  more = by_outlines;
  more.insert(more.end(), {"--rods_path", rods});
  const LimnRun as_rods = Run("drawing_evaluator", more);
  ASSERT_EQ(as_rods.exit_code, 0) << as_rods.err;
  EXPECT_THAT(as_rods.out, HasSubstr("\nlinks 2,"));
  EXPECT_THAT(as_rods.out, HasSubstr("rods, at tau 0.01: 100.0 % of 1 told as rods, drawn 1 times, "
                                     "false rods 0 per true length, median error 0\n"));
  const LimnRun alone = Run("drawing_evaluator", {"--truth_mesh_path", truth, "--rods_path", rods});
  EXPECT_THAT(alone.err, HasSubstr("rods_path: needs truth_path"));
}

// Drawn with refined cameras in a world that is turned and twice as large.
TEST_F(WorkspaceDrawing, IsJudgedInTheFrameOfTheTrueCameras) {
  Store("truth.json");
  const Similarity3d moved = {
      2, Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).matrix(), {1, 2, 3}};
  drawing_.graph =
      Transformed(std::move(drawing_.graph), moved.scale, moved.rotation, moved.translation);
  fs::create_directories(dir_ / "results");
  colmap_ext::SparseModel model = colmap_ext::ReadColmapModel(dir_ / "sparse");
  for (auto& image : model.images) image.cam_from_world = CamFromB(image.cam_from_world, moved);
  colmap_ext::WriteModelText(model, dir_ / "results/refined");
  drawing_.metadata.refined_cameras = colmap_ext::NameOfRefinedCameras(dir_ / "results/refined");
  Store("results/drawing.json");
  const LimnRun judged =
      Run("drawing_evaluator",
          {"--input_path", Path("results/drawing.json"), "--truth_path", Path("truth.json"),
           "--taus", "0.1", "--unit", "footprint", "--true_model_path", Path("sparse")});
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("fits, " + Path("results/refined") + "\n"));
  EXPECT_THAT(judged.out, HasSubstr(" 0.1      100.0      100.0      100.0"));
  EXPECT_THAT(judged.out, HasSubstr("cameras off, median of 24: centers "));
  const LimnRun without =
      RunLimn({"drawing_evaluator", "--input_path", Path("truth.json"), "--truth_path",
               Path("truth.json"), "--taus", "1", "--true_model_path", Path("sparse")});
  EXPECT_THAT(without.err, HasSubstr("true_model_path: needs workspace_path"));
}

TEST_F(WorkspaceDrawing, WhatFacesCannotBeJudgedByIsRefused) {
  Store("drawing.json");
  const std::string truth = dir_.WriteFile("truth.obj", kTwoSquares);
  const auto refused = [&](const std::vector<std::string>& more, const std::string& text) {
    const LimnRun run = Run("drawing_evaluator", more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr(text));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  };
  refused({}, "--truth_path or --truth_mesh_path must be given");
  refused({"--truth_path", truth, "--taus", "1", "--mesh_path", truth}, "needs truth_mesh_path");
  refused({"--truth_mesh_path", truth, "--input_path", truth}, "only a drawing.json or mesh_path");
  refused({"--truth_mesh_path", truth, "--Faces.min_views", "25"}, "at most the number of views");
  refused({"--truth_mesh_path", Path("none.ply")}, "none.ply");
  const LimnRun run = RunLimn(
      {"drawing_evaluator", "--truth_mesh_path", truth, "--input_path", Path("drawing.json")});
  EXPECT_THAT(run.err, HasSubstr("--workspace_path must be given"));
}

}  // namespace
}  // namespace limn::testing
