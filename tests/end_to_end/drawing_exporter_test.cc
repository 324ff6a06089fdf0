// SPDX-License-Identifier: BSD-3-Clause
// `limn drawing_exporter`: its options, and the files that Python's XML parser reads back. Formats
// of CAD and of Blender are in drawing_exporter_<format>_test.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/primitive_drawing.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(DrawingExporter, GraphmlIsTheGraph) {
  const DrawingGraph graph = PrimitiveDrawing();
  const ExportedDrawing exported(graph);
  exported.Export("graph.graphml");
  const nlohmann::json read = exported.Read("read_graphml.py", "graph.graphml");
  EXPECT_EQ(read.at("edgedefault"), "undirected");
  ASSERT_EQ(read.at("nodes").size(), graph.nodes.size());
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    const nlohmann::json& node = read.at("nodes")[n];
    EXPECT_EQ(node.at("id"), "n" + std::to_string(n));
    EXPECT_EQ(Eigen::Vector3d(node.at("x"), node.at("y"), node.at("z")),
              graph.nodes[n].position_in_world);
    EXPECT_EQ(node.at("kind"), NodeKindName(graph.nodes[n].kind));
    EXPECT_EQ(node.at("degree"), graph.nodes[n].Degree());
  }
  ASSERT_EQ(read.at("edges").size(), graph.links.size());
  const std::vector<std::string> primitives = {"line",     "arc",    "spline",   "line",
                                               "polyline", "arc",    "polyline", "circle",
                                               "polyline", "spline", "arc",      "arc"};
  ASSERT_EQ(primitives.size(), graph.links.size());
  int num_loops = 0;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const nlohmann::json& edge = read.at("edges")[l];
    EXPECT_EQ(edge.at("link"), l);
    EXPECT_EQ(edge.at("source"), "n" + std::to_string(graph.links[l].node0));
    EXPECT_EQ(edge.at("target"), "n" + std::to_string(graph.links[l].node1));
    EXPECT_EQ(edge.at("length"), Length(graph.links[l].points_in_world));
    EXPECT_EQ(edge.at("points"), graph.links[l].points_in_world.size());
    EXPECT_EQ(edge.at("views"), 2);
    EXPECT_EQ(edge.at("residual_px"), 0.1);
    EXPECT_EQ(edge.at("primitive"), primitives[l]);
    EXPECT_EQ(edge.at("class"), l == 3 ? "boundary" : l == 4 ? "surface" : "unknown");
    num_loops += edge.at("source") == edge.at("target");
  }
  EXPECT_EQ(num_loops, 3);  // a circle, a closed polyline, a closed spline
  // Parallel edges are two.
  EXPECT_EQ(read.at("edges")[5].at("source"), read.at("edges")[6].at("source"));
  EXPECT_EQ(read.at("edges")[5].at("target"), read.at("edges")[6].at("target"));
}

TEST(DrawingExporter, KindsAndTentativeLinksCanBeChosen) {
  DrawingGraph graph = PrimitiveDrawing();
  graph.links[0].kind = LinkKind::kShadow;
  graph.links[1].kind = LinkKind::kContour;
  graph.links[2].tentative = true;
  const ExportedDrawing exported(graph);
  const auto num_links = [&](const std::vector<std::string>& options) {
    std::vector<std::string> again = options;
    again.insert(again.end(), {"--overwrite", "1"});
    exported.Export("d.json", again);
    return ReadDrawingJson(exported.Path("d.json")).graph.links.size();
  };
  const size_t all = graph.links.size();
  EXPECT_EQ(num_links({}), all - 2);
  EXPECT_EQ(num_links({"--tentative", "1"}), all - 1);
  EXPECT_EQ(num_links({"--tentative", "1", "--kinds", "all"}), all);
  EXPECT_EQ(num_links({"--kinds", "unknown"}), all - 3);
  EXPECT_EQ(num_links({"--kinds", "shadow,contour"}), 2u);
}

TEST(DrawingExporter, DetailCanBeChosen) {
  DrawingGraph graph = PrimitiveDrawing();
  for (DrawingLink& link : graph.links) link.curve_px = 79;
  graph.links[0].kind = LinkKind::kTexture;
  graph.links[1].curve_px = 81;
  const ExportedDrawing exported(graph);
  const auto num_links = [&](const std::string& detail) {
    exported.Export("d.json", {"--overwrite", "1", "--detail", detail});
    return ReadDrawingJson(exported.Path("d.json")).graph.links.size();
  };
  EXPECT_EQ(num_links("all"), graph.links.size());
  EXPECT_EQ(num_links("normal"), graph.links.size() - 1);
  EXPECT_EQ(num_links("coarse"), 1u);
  const LimnRun bad = exported.TryExport("e.json", {"--detail", "fine"});
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.err, HasSubstr("detail = fine"));
  EXPECT_THAT(bad.err, HasSubstr("coarse, normal, all"));
}

TEST(DrawingExporter, SaysThatItDoesNotKnowWhichCurvesAreShort) {
  const ExportedDrawing exported(PrimitiveDrawing());
  const LimnRun coarse = exported.TryExport("d.json", {"--detail", "coarse"});
  EXPECT_EQ(coarse.exit_code, 0);
  EXPECT_THAT(coarse.out, HasSubstr("detail = coarse leaves out no short curves"));
  EXPECT_EQ(ReadDrawingJson(exported.Path("d.json")).graph.links.size(),
            PrimitiveDrawing().links.size());
}

TEST(DrawingExporter, LosesNoDrawingNoModelAndNoFileOfTheUser) {
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.dir().WriteFile("cameras.bin", "a model");
  exported.dir().WriteFile("mine.obj", "v 0 0 0\n");
  exported.Export("ours.obj");
  exported.Export("ours.obj");
  const auto before = ReadTree(exported.dir().path());
  for (const auto& [name, why] : {std::pair("drawing.json", "is an input"),
                                  {"cameras.bin", "exists, and was not made by limn"},
                                  {"mine.obj", "exists, and was not made by limn"}}) {
    const LimnRun run = exported.TryExport(name, {"--output_type", "obj"});
    EXPECT_EQ(run.exit_code, 1) << name;
    EXPECT_EQ(run.err,
              "ERROR: " + exported.Path(name) + ": " + why + ": --overwrite 1 replaces it\n");
  }
  EXPECT_EQ(ReadTree(exported.dir().path()), before);
  exported.Export("mine.obj", {"--overwrite", "1"});
  EXPECT_EQ(ReadTree(exported.dir().path()).at("mine.obj"), before.at("ours.obj"));
}

TEST(DrawingExporter, ScaleAndUpAxis) {
  const DrawingGraph graph = PrimitiveDrawing();
  const ExportedDrawing exported(graph);
  exported.Export("upright.json", {"--scale", "1000", "--up_axis", "-y"});
  const DrawingGraph read = ReadDrawingJson(exported.Path("upright.json")).graph;
  ASSERT_EQ(read.nodes.size(), graph.nodes.size());
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    const Eigen::Vector3d& p = graph.nodes[n].position_in_world;
    EXPECT_EQ(read.nodes[n].position_in_world,
              Eigen::Vector3d(1000 * p.x(), 1000 * p.z(), -1000 * p.y()));
  }
  for (size_t l = 0; l < graph.links.size(); ++l) {
    EXPECT_NEAR(ShapeLength(read.links[l]) / ShapeLength(graph.links[l]), 1000, 1e-6);
  }
}

TEST(DrawingExporter, TypeByExtensionOrByOption) {
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.Export("a.GraphML");
  exported.Export("b.txt", {"--output_type", "graphml"});
  exported.Export("new/folder/c.graphml");
  const auto files = ReadTree(exported.dir().path());
  EXPECT_EQ(files.at("a.GraphML"), files.at("b.txt"));
  EXPECT_EQ(files.at("a.GraphML"), files.at("new/folder/c.graphml"));
}

TEST(DrawingExporter, GlbWithACloud) {
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.dir().WriteFile("cloud.ply",
                           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n");
  exported.Export("without.glb");
  exported.Export("with.glb", {"--cloud_path", exported.Path("cloud.ply")});
  const auto files = ReadTree(exported.dir().path());
  EXPECT_THAT(files.at("with.glb"), AllOf(StartsWith("glTF"), HasSubstr("\"name\":\"cloud\"")));
  EXPECT_THAT(files.at("without.glb"), ::testing::Not(HasSubstr("\"cloud\"")));
  const LimnRun refused = exported.TryExport("a.dxf", {"--cloud_path", exported.Path("cloud.ply")});
  EXPECT_THAT(refused.err, HasSubstr("only .glb files hold a cloud"));
}

TEST(DrawingExporter, RodsByCenterLinesOutlinesOrTubes) {
  DrawingGraph graph = PrimitiveDrawing();
  graph.links[0].kind = LinkKind::kRod;
  graph.links[0].rod_radius = 0.0625;
  graph.links[3].tentative = true;
  graph.links[3].doubt = LinkDoubt::kRodOutline;
  const ExportedDrawing exported(graph);
  exported.Export("lines.json", {"--scale", "2"});
  const DrawingGraph lines = ReadDrawingJson(exported.Path("lines.json")).graph;
  ASSERT_EQ(lines.links.size(), graph.links.size() - 1);
  EXPECT_EQ(lines.links[0].rod_radius, 0.125);
  exported.Export("outlines.json", {"--rods_as_outlines", "1"});
  const DrawingGraph outlines = ReadDrawingJson(exported.Path("outlines.json")).graph;
  ASSERT_EQ(outlines.links.size(), graph.links.size() - 1);
  EXPECT_EQ(outlines.links[2].doubt, LinkDoubt::kRodOutline);
  exported.Export("lines.glb");
  exported.Export("tubes.glb", {"--rods_as_tubes", "1"});
  const auto files = ReadTree(exported.dir().path());
  EXPECT_THAT(files.at("tubes.glb"), HasSubstr("\"name\":\"rods\""));
  EXPECT_THAT(files.at("lines.glb"), ::testing::Not(HasSubstr("\"name\":\"rods\"")));
  for (const char* name : {"a.obj", "a.json", "a.svg"}) {
    const LimnRun refused = exported.TryExport(name, {"--rods_as_tubes", "1", "--view", "top"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_EQ(refused.err, "ERROR: rods_as_tubes: only in .glb and .step files\n");
  }
  for (const char* name : {"a.ply", "a.json", "a.glb"}) {
    const LimnRun refused = exported.TryExport(name, {"--segments", "1"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_EQ(refused.err, "ERROR: segments: only in .dxf and .obj files\n");
  }
}

// STEP by the command; what is in the file is tested in limn/formats.
TEST(DrawingExporter, StepWhereItIsBuilt) {
#ifndef LIMN_WITH_STEP
  GTEST_SKIP() << "built without OpenCASCADE";
#endif
  const ExportedDrawing exported(PrimitiveDrawing());
  exported.Export("a.step", {"--unit", "m"});
  exported.Export("b.step", {"--scale", "1000"});
  DrawingGraph with_rod = PrimitiveDrawing();
  with_rod.links[0].kind = LinkKind::kRod;
  with_rod.links[0].rod_radius = 0.0625;
  const ExportedDrawing rod(with_rod);
  rod.Export("tube.step", {"--rods_as_tubes", "1"});
  EXPECT_THAT(ReadTree(rod.dir().path()).at("tube.step"), HasSubstr("MANIFOLD_SOLID_BREP("));
  const auto files = ReadTree(exported.dir().path());
  EXPECT_THAT(files.at("a.step"), StartsWith("ISO-10303-21;"));
  EXPECT_EQ(files.at("a.step"), files.at("b.step"));
}

// The program alone, as where its plug-ins are not installed.
class WithoutPlugins : public ::testing::Test {
 protected:
  LimnRun Export(const std::string& name) const {
    return RunProgram((folder_ / "limn").string(),
                      {"drawing_exporter", "--input_path", exported_.Path("drawing.json"),
                       "--output_path", (alone_ / name).string()});
  }
  void SetUp() override {
    fs::create_directories(folder_ / "lib/limn/plugins");
    fs::copy_file(LIMN_PROGRAM, folder_ / "limn");
    plugin_ = (fs::canonical(folder_) / "lib/limn/plugins/limn_step.so").string();
  }

  TempDir alone_;
  const fs::path folder_ = alone_ / "no/system/near";
  std::string plugin_;
  const ExportedDrawing exported_{PrimitiveDrawing()};
};

TEST_F(WithoutPlugins, OnlyWhatNeedsThemFails) {
  EXPECT_EQ(Export("a.dxf").exit_code, 0);
  const LimnRun run = Export("a.step");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: " + (fs::canonical(folder_) / "limn").string() +
                                        ": has no part limn_step.so beside it: "),
                             HasSubstr("limn-step")));
  EXPECT_FALSE(fs::exists(alone_ / "a.step"));
}

TEST_F(WithoutPlugins, DamagedOnesAreNamed) {
  std::ofstream(plugin_) << "no library";
  const LimnRun run = Export("a.step");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: " + plugin_ + ": cannot be loaded: "));
}

// Any other library.
TEST_F(WithoutPlugins, ThoseOfAnotherBuildAreRefused) {
  fs::copy_file(LIMN_NO_FLOCK, plugin_);
  const LimnRun run = Export("a.step");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: " + plugin_ + ": is of build unknown, but this is 0."));
}

// Whatever is in them.
TEST_F(WithoutPlugins, ThoseThatAnybodyMayWriteAreNotLoaded) {
  fs::copy_file(LIMN_NO_FLOCK, plugin_);
  fs::permissions(plugin_, fs::perms::others_write, fs::perm_options::add);
  const LimnRun run = Export("a.step");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: " + plugin_ + ": is not loaded: "));
}

class BadExport : public ::testing::Test {
 protected:
  void ExpectRefused(const LimnRun& run, const auto& line_matcher) {
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), line_matcher));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(ReadTree(exported_.dir().path()), before_);
  }

  ExportedDrawing exported_{PrimitiveDrawing()};
  std::map<std::string, std::string> before_ = ReadTree(exported_.dir().path());
};

TEST_F(BadExport, Options) {
  ExpectRefused(exported_.TryExport("a.graphml", {"--scale", "0"}), HasSubstr("scale = 0"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--scale", "-2"}), HasSubstr("scale = -2"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--scale", "nan"}), HasSubstr("scale = nan"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--scale", "1e308"}),
                HasSubstr("scale = 1e+308: must be >= 1e-12 and <= 1e12"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--up_axis", "w"}), HasSubstr("up_axis = w"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--output_type", "dwg"}),
                HasSubstr("output_type = dwg"));
  ExpectRefused(exported_.TryExport("a.graphml", {"--kinds", "edge,ink"}), HasSubstr("\"ink\""));
  ExpectRefused(RunLimn({"drawing_exporter", "--output_path", exported_.Path("a.graphml")}),
                HasSubstr("input_path"));
  ExpectRefused(RunLimn({"drawing_exporter", "--input_path", exported_.Path("drawing.json")}),
                HasSubstr("output_path"));
}

TEST_F(BadExport, Extension) {
  ExpectRefused(exported_.TryExport("a.dwg"), AllOf(HasSubstr("a.dwg"), HasSubstr(".graphml")));
  ExpectRefused(exported_.TryExport("a"), HasSubstr("unknown extension"));
}

TEST_F(BadExport, NumbersThatRunOver) {
  auto drawing = nlohmann::json::parse(before_.at("drawing.json"));
  for (auto& link : drawing.at("links")) {
    if (link.at("points").size() > 2) link.at("points").at(1) = {1e300, 0, 0};
  }
  exported_.dir().WriteFile("drawing.json", drawing.dump());
  before_ = ReadTree(exported_.dir().path());
  ExpectRefused(exported_.TryExport("a.graphml", {"--scale", "1e12"}),
                HasSubstr("a number from -1e15 to 1e15 expected"));
}

TEST_F(BadExport, Input) {
  const auto run = [&](const std::string& name) {
    return RunLimn({"drawing_exporter", "--input_path", exported_.Path(name), "--output_path",
                    exported_.Path("a.graphml")});
  };
  ExpectRefused(run("none.json"), HasSubstr("none.json"));
  exported_.dir().WriteFile("cut.json", before_.at("drawing.json").substr(0, 1000));
  exported_.dir().WriteFile("other.json", "{\"format\": \"other\"}");
  before_ = ReadTree(exported_.dir().path());
  ExpectRefused(run("cut.json"), HasSubstr("cut.json"));
  ExpectRefused(run("other.json"), HasSubstr("limn-drawing"));
}

TEST_F(BadExport, OutputFolderThatCannotBeMade) {
  ExpectRefused(exported_.TryExport("drawing.json/a.graphml"), HasSubstr("drawing.json"));
}

}  // namespace
}  // namespace limn::testing
