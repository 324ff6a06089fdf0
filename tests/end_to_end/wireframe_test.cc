// SPDX-License-Identifier: BSD-3-Clause
// A drawing becomes a wireframe, which the evaluator scores as the S23DR challenge does.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/exported_drawing.h"
#include "limn/formats/wireframe_files.h"

namespace limn::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A frame of 2 x 1 units whose sides bend by up to 0.002, cut into two links per side.
DrawingGraph Frame() {
  DrawingGraph graph;
  const std::vector<Eigen::Vector3d> around = {{0, 0, 0},       {1, 0, 0.002},  {2, 0, 0},
                                               {2, 0.5, 0.002}, {2, 1, 0},      {1, 1, 0.002},
                                               {0, 1, 0},       {0, 0.5, 0.002}};
  for (size_t i = 0; i < around.size(); ++i) {
    DrawingNode node;
    node.position_in_world = around[i];
    graph.nodes.push_back(node);
    DrawingLink link;
    link.node0 = static_cast<int>(i);
    link.node1 = static_cast<int>((i + 1) % around.size());
    link.points_in_world = {around[i], around[link.node1]};
    link.sigma.assign(2, 0.001);
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  return graph;
}

// A unit is 4 m.
Alignment FourMeters() {
  Alignment alignment;
  alignment.world_from_model.scale = 4;
  alignment.scale = ScaleSource::kLengths;
  return alignment;
}

// The frame in meters, whose lower side is 0.4 m off.
const Wireframe kTrueFrame = {{{0, -0.4, 0}, {8, -0.4, 0}, {8, 4, 0}, {0, 4, 0}},
                              {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};

class WireframeTest : public ::testing::Test {
 protected:
  std::string Store(const std::string& name, const Wireframe& wireframe,
                    const WireframeStamp& stamp = {}) const {
    std::ofstream out(drawn_.Path(name));
    WriteWireframeObj(wireframe, {}, stamp, out);
    return drawn_.Path(name);
  }

  LimnRun Judge(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"drawing_evaluator", "--protocol", "hss"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  nlohmann::json Scores(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = more;
    arguments.insert(arguments.end(), {"--output_json", drawn_.Path("hss.json")});
    const LimnRun run = Judge(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::ifstream file(drawn_.Path("hss.json"));
    return nlohmann::json::parse(file).at("hss");
  }

  ExportedDrawing drawn_{Frame(), FourMeters()};
};

TEST_F(WireframeTest, IsExportedInMetersAndScored) {
  drawn_.Export("w.obj", {"--output_type", "wireframe", "--aligned", "1"});
  const auto wireframe = ReadWireframe(drawn_.Path("w.obj"));
  ASSERT_TRUE(wireframe);
  EXPECT_EQ(wireframe->vertices,
            (std::vector<Eigen::Vector3d>{{0, 0, 0}, {0, 4, 0}, {8, 0, 0}, {8, 4, 0}}));
  EXPECT_EQ(wireframe->edges.size(), 4u);
  const nlohmann::json scores = Scores(
      {"--input_path", drawn_.Path("w.obj"), "--truth_path", Store("truth.obj", kTrueFrame)});
  EXPECT_EQ(scores.at("corner_f1"), 1);
  EXPECT_EQ(scores.at("num_right_corners"), 4);
  EXPECT_GT(scores.at("edge_iou"), 0.6);
  EXPECT_LT(scores.at("edge_iou"), 0.9);
  const double iou = scores.at("edge_iou");
  EXPECT_NEAR(scores.at("hss"), 2 * iou / (1 + iou), 1e-12);
  // The drawing itself, by its scale, to within its bends.
  const std::string model_truth =
      Store("model.obj", {{{0, -0.1, 0}, {2, -0.1, 0}, {2, 1, 0}, {0, 1, 0}}, kTrueFrame.edges});
  const nlohmann::json of_drawing =
      Scores({"--input_path", drawn_.Path("drawing.json"), "--truth_path", model_truth});
  EXPECT_EQ(of_drawing.at("corner_f1"), 1);
  EXPECT_NEAR(of_drawing.at("edge_iou"), iou, 1e-9);
}

TEST_F(WireframeTest, JsonAndTables) {
  drawn_.Export("w.json",
                {"--output_type", "wireframe", "--unit", "m", "--Wireframe.tolerance", "0.125"});
  std::ifstream file(drawn_.Path("w.json"));
  const nlohmann::json json = nlohmann::json::parse(file);
  EXPECT_EQ(json.at("format"), "limn-wireframe");
  EXPECT_EQ(json.at("unit"), "m");
  EXPECT_EQ(json.at("tolerance"), 0.125);
  EXPECT_EQ(json.at("wf_vertices").size(), 4u);
  const LimnRun run = Judge({"--input_path", drawn_.Path("w.json"), "--truth_path",
                             drawn_.Path("w.json"), "--output_csv", drawn_.Path("hss.csv")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("corners right 4 of 4, true 4; edges 4, true 4"),
                             HasSubstr("100.0"), Not(HasSubstr("WARNING"))));
  std::ifstream table(drawn_.Path("hss.csv"));
  std::string names, values;
  std::getline(table, names);
  std::getline(table, values);
  EXPECT_THAT(names, StartsWith("corner_f1,edge_iou,hss,corner_precision"));
  EXPECT_THAT(values, StartsWith("1.0,1.0,1.0,1.0,1.0,4,4,4,4,4,"));
  // Its own files may be replaced.
  EXPECT_EQ(drawn_.TryExport("w.json", {"--output_type", "wireframe"}).exit_code, 0);
  EXPECT_EQ(Judge({"--input_path", drawn_.Path("w.json"), "--truth_path",
                   Store("truth.obj", kTrueFrame), "--output_csv", drawn_.Path("hss.csv")})
                .exit_code,
            0);
}

TEST_F(WireframeTest, SaysWhatItTakesForAMeter) {
  const std::string truth = Store("truth.obj", kTrueFrame);
  const LimnRun known = Judge({"--input_path", drawn_.Path("drawing.json"), "--truth_path", truth});
  EXPECT_THAT(known.out, HasSubstr("scale: 4 m per unit, as the drawing is aligned"));
  EXPECT_THAT(known.out, HasSubstr("wireframe: 8 curves reduced to 4 corners and 4 edges, "
                                   "tolerance 0.0894 m"));
  drawn_.Export("curves.ply");
  const LimnRun unknown = Judge({"--input_path", drawn_.Path("curves.ply"), "--truth_path", truth});
  EXPECT_THAT(unknown.out + unknown.err, HasSubstr("WARNING: the scale is not known"));
  const LimnRun given =
      Judge({"--input_path", drawn_.Path("curves.ply"), "--truth_path", truth, "--scale", "4"});
  EXPECT_THAT(given.out + given.err, Not(HasSubstr("the scale is not known")));
}

TEST_F(WireframeTest, TheBoxIsInUnitsOfTheTruth) {
  Wireframe in_mm = kTrueFrame;
  for (Eigen::Vector3d& vertex : in_mm.vertices) vertex *= 1000;
  const std::string truth = Store("truth.obj", in_mm, {.unit = LengthUnit::kMillimeter});
  const nlohmann::json scores = Scores({"--input_path", drawn_.Path("drawing.json"), "--truth_path",
                                        truth, "--box=-1000,4500,-1000,4500,-1000,1000"});
  EXPECT_EQ(scores.at("num_true_corners"), 2);
  EXPECT_EQ(scores.at("num_right_corners"), 2);
}

TEST_F(WireframeTest, RefusesWhatDoesNotGoWithIt) {
  const std::string truth = Store("truth.obj", kTrueFrame);
  const auto expect_refused = [&](std::vector<std::string> more, const std::string& error) {
    more.insert(more.end(), {"--input_path", drawn_.Path("drawing.json")});
    const LimnRun run = Judge(more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr("ERROR: " + error));
  };
  expect_refused({"--truth_path", truth, "--taus", "1"},
                 "taus: only by protocol = curves; hss has");
  expect_refused({"--truth_path", truth, "--unit", "footprint", "--workspace_path", "/nowhere"},
                 "unit = footprint: only by protocol = curves");
  expect_refused({"--truth_path", truth, "--rods_path", truth},
                 "rods_path: only by protocol = curves");
  expect_refused({"--truth_path", truth, "--Hss.edge_radius", "0"}, "Hss.edge_radius = 0: must be");
  expect_refused({"--truth_path", truth, "--scale", "-1"}, "scale = -1: must be");
  expect_refused({"--truth_path", Store("empty.obj", {})},
                 drawn_.Path("empty.obj") + ": no corners and no edges (truth_path)");
  std::ofstream(drawn_.Path("points.txt")) << "0 0 0\n1 0 0\n";
  expect_refused({"--truth_path", drawn_.Path("points.txt")},
                 drawn_.Path("points.txt") + ": has only points; a wireframe has edges");
  EXPECT_THAT(drawn_.TryExport("w.dxf", {"--output_type", "wireframe"}).err,
              HasSubstr("wireframes are written as .obj or .json"));
}

TEST_F(WireframeTest, OfAnEmptyDrawingScoresNothing) {
  const nlohmann::json scores = Scores(
      {"--input_path", Store("empty.obj", {}), "--truth_path", Store("truth.obj", kTrueFrame)});
  EXPECT_EQ(scores.at("hss"), 0);
  EXPECT_EQ(scores.at("num_true_corners"), 4);
}

}  // namespace
}  // namespace limn::testing
