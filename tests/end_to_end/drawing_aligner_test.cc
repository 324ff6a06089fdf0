// SPDX-License-Identifier: BSD-3-Clause
// Up, axes and scale of drawings, stored and applied on request.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/test_database.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/alignment/known_lengths.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/angle_between.h"
#include "limn/geometry/polyline.h"
#include "limn/util/angles.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The sample is in meters and z is up in it: databases tell another world.
const Similarity3d& WorldFromSample() {
  static const Similarity3d world = {
      2, Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix(), {5, 6, 7}};
  return world;
}

class DrawingAligner : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new SmallScene;
    const LimnRun run = RunLimn(scene_->Arguments({"--align", "auto", "--page", "0"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    said_ = run.out;
    before_ = ReadTree(scene_->output());
  }
  static void TearDownTestSuite() { delete scene_; }
  // Every test starts with the drawing as automatic_drawer has made it.
  void TearDown() override {
    fs::copy_file(Kept(), Drawing(), fs::copy_options::overwrite_existing);
  }
  void SetUp() override { fs::copy_file(Drawing(), Kept()); }

  std::string Drawing() const { return (*scene_ / "drawing.json").string(); }
  std::string Kept() const { return (dir_ / "kept.json").string(); }
  DrawingFile Read() const { return ReadDrawingJson(Drawing()); }

  LimnRun Align(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = scene_->Arguments(more);
    arguments[0] = "drawing_aligner";
    return RunLimn(arguments);
  }

  static SmallScene* scene_;
  static std::string said_;
  static std::map<std::string, std::string> before_;
  TempDir dir_;
};
SmallScene* DrawingAligner::scene_ = nullptr;
std::string DrawingAligner::said_;
std::map<std::string, std::string> DrawingAligner::before_;

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return Degrees(AngleBetween(a, b));
}

TEST_F(DrawingAligner, AutomaticDrawerFindsUpByTheLines) {
  const DrawingFile drawing = Read();
  ASSERT_TRUE(drawing.metadata.alignment);
  const Alignment& alignment = *drawing.metadata.alignment;
  EXPECT_EQ(alignment.up, UpSource::kLines);
  EXPECT_EQ(alignment.scale, ScaleSource::kNone);
  const Eigen::Vector3d up = alignment.world_from_model.rotation.row(2);
  EXPECT_LT(AngleDeg(up, Eigen::Vector3d::UnitZ()), 1);
  EXPECT_THAT(said_, AllOf(HasSubstr("alignment: no database.db near the model\n"),
                           HasSubstr("alignment: up from the lines"),
                           HasSubstr("alignment: scale unknown")));
}

TEST_F(DrawingAligner, NothingElseChangesWithoutARequest) {
  const SmallScene plain;
  const LimnRun run = RunLimn(plain.Arguments({"--page", "0"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, Not(HasSubstr("alignment")));
  auto without = ReadTree(plain.output());
  auto with = before_;
  for (auto* files : {&without, &with}) files->erase("curves/project.ini");
  std::string& drawing = with["drawing.json"];
  const size_t begin = drawing.find("\"world_from_model\"");
  ASSERT_NE(begin, std::string::npos);
  drawing.erase(begin, drawing.find('\n', begin) + 1 - begin);
  EXPECT_EQ(without, with);
}

TEST_F(DrawingAligner, CamerasOfADatabaseTellAll) {
  std::vector<StoredPrior> priors;
  for (const auto& image : colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse").images) {
    const Eigen::Vector3d center = Inverse(image.cam_from_world).translation;
    priors.push_back({image.name, WorldFromSample() * center, 1});
  }
  const fs::path database = dir_ / "priors.db";
  WriteDatabase(database, DatabaseVersion::k4_1, priors);
  const LimnRun run = Align({"--database_path", database.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("positions of 6 and gravity of 0 of 6 images"),
                             HasSubstr("alignment: up from positions of cameras")));
  const DrawingFile drawing = Read();
  ASSERT_TRUE(drawing.metadata.alignment);
  const Alignment& alignment = *drawing.metadata.alignment;
  EXPECT_EQ(alignment.scale, ScaleSource::kPositions);
  EXPECT_NEAR(alignment.world_from_model.scale, 2, 1e-4);
  const Eigen::Vector3d up = alignment.world_from_model.rotation.row(2);
  EXPECT_LT(AngleDeg(up, WorldFromSample().rotation.row(2)), 0.01);
  // Only that line of drawing.json is another.
  auto after = ReadTree(scene_->output());
  const auto before = before_;
  for (const auto& [name, bytes] : before) {
    if (name != "drawing.json") {
      EXPECT_EQ(after[name], bytes) << name;
    }
  }
}

TEST_F(DrawingAligner, KnownLengthsMakeExportsMetric) {
  const DrawingGraph graph = Read().graph;
  const auto distance = [&](NodeId a, NodeId b) {
    return (graph.nodes[a].position_in_world - graph.nodes[b].position_in_world).norm();
  };
  char first[80], second[80];
  std::snprintf(first, sizeof(first), "from 0 to 3 = %.6f m", 3 * distance(0, 3));
  std::snprintf(second, sizeof(second), "from 1 to 4 = %.6f cm", 303 * distance(1, 4));
  const LimnRun run = Align({"--known_length", first, "--known_length", second});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr(std::string("alignment: ") + first + ": "),
                             HasSubstr(std::string("alignment: ") + second + ": "),
                             HasSubstr("m per unit of the model, from known lengths")));
  const Alignment alignment = *Read().metadata.alignment;
  EXPECT_NEAR(alignment.world_from_model.scale, 3.015, 0.016);

  const std::string exported = (dir_ / "aligned.json").string();
  const LimnRun export_run =
      RunLimn({"drawing_exporter", "--input_path", Drawing(), "--output_path", exported,
               "--aligned", "1", "--kinds", "all", "--tentative", "1"});
  ASSERT_EQ(export_run.exit_code, 0) << export_run.err;
  const DrawingFile aligned = ReadDrawingJson(exported);
  ASSERT_EQ(aligned.graph.links.size(), graph.links.size());
  EXPECT_LT((aligned.graph.links[0].points_in_world[0] -
             alignment.world_from_model * graph.links[0].points_in_world[0])
                .norm(),
            1e-12);
  // It says of itself that it is aligned.
  ASSERT_TRUE(aligned.metadata.alignment);
  EXPECT_NEAR(aligned.metadata.alignment->world_from_model.scale, 1, 1e-12);
  EXPECT_EQ(aligned.metadata.alignment->scale, ScaleSource::kLengths);

  const std::string dxf = (dir_ / "aligned.dxf").string();
  ASSERT_EQ(RunLimn({"drawing_exporter", "--input_path", Drawing(), "--output_path", dxf,
                     "--aligned", "1"})
                .exit_code,
            0);
  // $INSUNITS of meters.
  EXPECT_NE(ReadTree(dir_.path())["aligned.dxf"].find("$INSUNITS\n70\n6\n"), std::string::npos);
}

// As COLMAP counts them, in the photographs as stored, which are larger than those in use.
TEST_F(DrawingAligner, KnownLengthsAreBetweenPixelsOfPhotographs) {
  const colmap_ext::SparseModel model = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  const DrawingGraph graph = Read().graph;
  // The ends of a long link that two of the images show, some pixels inside.
  const auto pixel = [&](const colmap_ext::ModelImage& image, const Eigen::Vector3d& point) {
    const auto& params = model.CameraOf(image).params;
    const Eigen::Vector3d at = image.cam_from_world * point;
    return Eigen::Vector2d(params[0] * at.x() / at.z() + params[2],
                           params[1] * at.y() / at.z() + params[3]);
  };
  const DrawingLink* longest = nullptr;
  for (const DrawingLink& link : graph.links) {
    const bool is_line =
        link.primitive && std::holds_alternative<LineSegment>(link.primitive->shape);
    if (!is_line || link.supporting_views.size() < 4 || link.tentative) continue;
    if (!longest || Length(link.points_in_world) > Length(longest->points_in_world))
      longest = &link;
  }
  ASSERT_TRUE(longest);
  const Eigen::Vector3d a = longest->points_in_world.front(), b = longest->points_in_world.back();
  std::string text;
  for (const double share : {0.3, 0.7}) {
    const ViewId view = longest->supporting_views[share < 0.5 ? 0 : 1];
    const std::string name = Read().metadata.view_names[view];
    for (const auto& image : model.images) {
      if (image.name != name) continue;
      const Eigen::Vector2d at = pixel(image, a + share * (b - a));
      char part[80];
      std::snprintf(part, sizeof(part), "%s %.3f,%.3f", name.c_str(), at.x(), at.y());
      text += (text.empty() ? "" : " to ") + std::string(part);
    }
  }
  const double length = 0.4 * (b - a).norm();
  const LimnRun run = Align({"--known_length", text + " = 5 m"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(" px away\n"));
  const Alignment alignment = *Read().metadata.alignment;
  EXPECT_EQ(alignment.scale, ScaleSource::kLengths);
  EXPECT_NEAR(alignment.world_from_model.scale * length, 5, 0.15) << text << run.out;

  const LimnRun unknown = Align({"--known_length", "x.jpg 1,2 to x.jpg 3,4 = 5 m"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("no image in use is called x.jpg"));
}

// If this link is a meter long.
double ScaleByLink(const DrawingGraph& graph, LinkId id) {
  return FitLengths(graph, {{{id}, 1, ""}}).scale;
}

TEST_F(DrawingAligner, KnownLengthsAreOfTheDrawingThatIsShown) {
  // As drawing_fuser may leave it: with other ids.
  DrawingFile fused = Read();
  std::vector<uint8_t> keep(fused.graph.links.size(), 1);
  keep[0] = 0;
  RemoveLinks(keep, &fused.graph);
  fused.metadata.alignment.reset();
  const std::string path = (*scene_ / "drawing-fused.json").string();
  WriteDrawing(path, fused.graph, fused.metadata);
  const auto times = [&] {
    return std::pair(fs::last_write_time(path), fs::last_write_time(Drawing()));
  };
  const auto times_before = times();
  const LimnRun run = Align({"--known_length", "link 0 = 2 m"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("drawing: " + path + "\n"));
  const auto aligned = ReadDrawingJson(path).metadata.alignment;
  ASSERT_TRUE(aligned);
  EXPECT_NEAR(aligned->world_from_model.scale, 2 * ScaleByLink(fused.graph, 0), 1e-9);
  EXPECT_EQ(Read().metadata.alignment->world_from_model.scale, aligned->world_from_model.scale);
  // Commands still take the same drawing for the newest.
  EXPECT_EQ(times(), times_before);

  // Even if it is named.
  fs::last_write_time(path, fs::last_write_time(Drawing()) - std::chrono::seconds(5));
  const auto times_of_older = times();
  ASSERT_EQ(Align({"--drawing_path", path}).exit_code, 0);
  EXPECT_EQ(times(), times_of_older);

  // An older one stays as it is, and older.
  const auto bytes = ReadTree(scene_->output())["drawing-fused.json"];
  const LimnRun again = Align({"--known_length", "link 0 = 2 m"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out + again.err,
              AllOf(HasSubstr("drawing: " + Drawing() + "\n"),
                    HasSubstr("WARNING: " + path + " is older than " + Drawing())));
  EXPECT_NEAR(Read().metadata.alignment->world_from_model.scale, 2 * ScaleByLink(Read().graph, 0),
              1e-9);
  EXPECT_EQ(ReadTree(scene_->output())["drawing-fused.json"], bytes);
  EXPECT_LT(fs::last_write_time(path), fs::last_write_time(Drawing()));
  fs::remove(path);
}

TEST_F(DrawingAligner, AFusedDrawingMayBeAlone) {
  const std::string path = (*scene_ / "drawing-fused.json").string();
  fs::rename(Drawing(), path);
  const LimnRun run = Align({"--known_length", "link 0 = 2 m"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("drawing: " + path + "\n"),
                             HasSubstr("Written: alignment in " + path + "\n")));
  EXPECT_FALSE(fs::exists(Drawing()));
  EXPECT_EQ(ReadDrawingJson(path).metadata.alignment->scale, ScaleSource::kLengths);
  fs::remove(path);
}

TEST_F(DrawingAligner, ThePageShowsTheWorld) {
  if (!HasViewerPage()) GTEST_SKIP() << "built without the viewer";
  ASSERT_EQ(Align({"--known_length", "link 0 = 2 m"}).exit_code, 0);
  std::vector<std::string> arguments = scene_->Arguments({"--aligned", "1"});
  arguments[0] = "drawing_viewer";
  const LimnRun run = RunLimn(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string path = (*scene_ / "drawing.html").string();
  const LimnRun read =
      RunProgram("/usr/bin/python3", {LIMN_SOURCE_DIR "/tests/scripts/readers/read_page.py", path});
  ASSERT_EQ(read.exit_code, 0) << read.err;
  const auto page = nlohmann::json::parse(read.out);
  const auto position = [&](const nlohmann::json& at) {
    Eigen::Vector3d sum;
    for (int axis = 0; axis < 3; ++axis) {
      sum[axis] = page.at("center")[axis].get<double>() + at[axis].get<double>();
    }
    return sum;
  };
  const DrawingFile drawing = Read();
  const Similarity3d& world_from_model = drawing.metadata.alignment->world_from_model;
  EXPECT_GT(std::abs(world_from_model.scale - 1), 0.1);
  // The way back to drawing.json, in which the page writes edits.
  const auto& told = page.at("shownFromModel");
  EXPECT_EQ(told.at("scale").get<double>(), world_from_model.scale);
  EXPECT_EQ(told.at("translation")[2].get<double>(), world_from_model.translation.z());
  EXPECT_EQ(told.at("rotation")[1].get<double>(), world_from_model.rotation(0, 1));
  EXPECT_EQ(page.at("unit"), "m");
  for (const size_t n : {size_t{0}, drawing.graph.nodes.size() - 1}) {
    const Eigen::Vector3d expected = world_from_model * drawing.graph.nodes[n].position_in_world;
    EXPECT_LT((position(page.at("nodes")[n]) - expected).norm(), 1e-5);
  }
  for (const auto& image : colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse").images) {
    if (image.name != "view_03.jpg") continue;
    const auto& view = page.at("views")[3];
    EXPECT_EQ(view.at("name"), image.name);
    const Eigen::Vector3d center = Inverse(image.cam_from_world).translation;
    EXPECT_LT((position(view.at("position")) - world_from_model * center).norm(), 1e-5);
    const Eigen::Matrix3d rotation =
        image.cam_from_world.rotation * world_from_model.rotation.transpose();
    for (int i = 0; i < 9; ++i) {
      EXPECT_NEAR(view.at("camFromWorld")[i].get<double>(), rotation(i / 3, i % 3), 1e-9);
    }
  }
  fs::remove(path);
}

TEST_F(DrawingAligner, ErrorsNameTheOptionAndChangeNothing) {
  const auto fails = [&](const std::vector<std::string>& more, const std::string& error) {
    const LimnRun run = Align(more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(::testing::StartsWith("ERROR: "), HasSubstr(error)));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_EQ(ReadTree(scene_->output())["drawing.json"], before_["drawing.json"]);
  };
  fails({"--known_length", "link 12 = 2.40"}, "known_length = link 12 = 2.40: must be like");
  fails({"--known_length", "link 99999 = 2.40 m"}, "the drawing has no link 99999");
  fails({"--database_path", "/nowhere/database.db"}, "/nowhere/database.db: is not a file");
  fails({"--drawing_path", "/nowhere/drawing.json"}, "/nowhere/drawing.json");
  fails({"--drawing_path", dir_.path().string()},
        ": is a folder, where no alignment can be stored");
}

TEST_F(DrawingAligner, OnlyAlignedDrawingsAreShownAligned) {
  std::string text = before_["drawing.json"];
  const size_t begin = text.find("\"world_from_model\"");
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  const std::string plain = dir_.WriteFile("plain.json", text);
  const LimnRun run = RunLimn({"drawing_exporter", "--input_path", plain, "--output_path",
                               (dir_ / "x.ply").string(), "--aligned", "1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "ERROR: " + plain +
                         ": has no alignment: run drawing_aligner, or draw with --align auto\n");
  EXPECT_FALSE(fs::exists(dir_ / "x.ply"));
}

}  // namespace
}  // namespace limn::testing
