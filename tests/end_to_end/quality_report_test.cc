// SPDX-License-Identifier: BSD-3-Clause
// The quality report on one small data set: every figure is there, and those of precision and
// recall are those of the commands.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

nlohmann::json ReadJson(const std::filesystem::path& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

// The same data set once more, as one without truth.
void AddPhotographs(const std::filesystem::path& report_path) {
  nlohmann::json report = ReadJson(report_path);
  nlohmann::json set = report.at("sets").at(0);
  set["name"] = "desk";
  set["ceiling"] = nullptr;
  for (nlohmann::json& run : set["runs"]) run["truth"] = nullptr;
  report["sets"].push_back(set);
  std::ofstream(report_path) << report;
}

// The page of a report with these files: a row per method, a picture.
void ExpectPageOfResults(const std::filesystem::path& folder) {
  const std::string python = "/usr/bin/python3";
  if (RunProgram(python, {"-c", "import matplotlib"}).exit_code != 0) return;  // no pictures
  AddPhotographs(folder / "report.json");
  const LimnRun run =
      RunProgram(python, {LIMN_SOURCE_DIR "/scripts/bench/results_page.py", "--commit", "abcdef",
                          "--report", (folder / "report.json").string(), folder.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string page = ReadText(folder / "RESULTS.md");
  for (const char* method :
       {"original sketch", "enhanced sketch", "paper drawing", "default drawing"}) {
    EXPECT_THAT(page, HasSubstr("| " + std::string(method) + " | "));
  }
  EXPECT_THAT(page, HasSubstr("at commit abcdef"));
  const size_t photographs = page.find("**desk**, 24 views, 2 held out:");
  ASSERT_NE(photographs, std::string::npos);
  const nlohmann::json to = ReadJson(folder / "report.json")
                                .at("sets")
                                .at(1)
                                .at("runs")
                                .at(0)
                                .at("held_out")
                                .at("to_edgels");
  char row[100];
  std::snprintf(row, sizeof(row), "| original sketch | %.2f / %.2f (%.1f) | ",
                to.at("median_px").get<double>(), to.at("p90_px").get<double>(),
                100 * to.at("lonely").get<double>());
  EXPECT_THAT(page.substr(photographs), HasSubstr(row));
  EXPECT_THAT(page, HasSubstr("`curves/enhanced-sketch.ply` of `limn automatic_drawer"));
  EXPECT_TRUE(std::filesystem::exists(folder / "results/precision-recall-sample.png"));
}

// The figures of a method as a user would get them by hand: `file` of its command, judged.
nlohmann::json RowsByHand(const std::vector<std::string>& arguments, const std::string& file) {
  const TempDir dir;
  const std::string sample = LIMN_SAMPLE_DIR;
  const std::string out = (dir / "out").string();
  const std::string report = (dir / "report.json").string();
  std::vector<std::string> command = {"automatic_drawer",
                                      "--workspace_path",
                                      sample + "/day",
                                      "--output_path",
                                      out,
                                      "--max_image_size",
                                      "160",
                                      "--page",
                                      "0"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  LimnRun run = RunLimn(command);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  // Distances in pixels of the images at their own size, which are four times as long.
  run = RunLimn({"drawing_evaluator", "--workspace_path", sample + "/day", "--input_path",
                 out + "/" + file, "--truth_path", sample + "/truth/curves-visible.ply",
                 "--dont_care_path", sample + "/truth/dont-care.ply",
                 "--box=-1.25,1.25,-0.95,0.95,0.04,1.05", "--unit", "footprint", "--taus", "4,8,16",
                 "--output_json", report});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return ReadJson(report).at("rows");
}

// What one of the thresholds of the sweep is, as options of the command.
std::vector<std::string> SweptOptions(const std::string& method) {
  if (method == "original sketch") return {"--Sketch.original_min_inliers_total", "250"};
  if (method == "enhanced sketch" || method == "paper drawing") {
    return {"--Sketch.min_supporting_views", "8"};
  }
  return {"--Sketch.min_supporting_views",  "8", "--Drawing.min_supporting_views", "8",
          "--Drawing.max_supporting_views", "8"};
}

void ExpectFiguresOfCommand(const nlohmann::json& run) {
  const std::map<std::string, std::string> files = {
      {"original sketch", "curves/sketch.ply"},          {"paper drawing", "drawing.json"},
      {"enhanced sketch", "curves/enhanced-sketch.ply"}, {"default drawing", "drawing.json"},
      {"swept sketch", "curves/swept-sketch.ply"},
  };
  const std::string method = run.at("method");
  std::vector<std::string> arguments = run.at("arguments");
  if (!run.at("threshold").is_null()) {
    const std::vector<std::string> swept = SweptOptions(method);
    if (std::to_string(run.at("threshold").get<int>()) != swept[1]) return;
    arguments.insert(arguments.end(), swept.begin(), swept.end());
  }
  const nlohmann::json rows = RowsByHand(arguments, files.at(method));
  for (int i = 0; i < 3; ++i) {
    // The report samples curves by pixels of the small images.
    for (const char* share : {"precision", "recall"}) {
      EXPECT_NEAR(run.at("truth").at("all").at("rows").at(i).at(share), rows.at(i).at(share), 0.005)
          << method << ", " << share << ", threshold " << run.at("threshold");
    }
  }
}

TEST(QualityReport, MeasuresEveryMethod) {
  const TempDir dir;
  const LimnRun run = RunProgram(
      QUALITY_REPORT_PROGRAM,
      {"--sets", "sample-day", "--output_path", dir.path().string(), "--max_image_size", "160"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json sets = ReadJson(dir / "report.json").at("sets");
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].at("name"), "sample-day");
  EXPECT_EQ(sets[0].at("num_held_out"), 2);
  EXPECT_EQ(sets[0].at("ceiling").at("all").size(), 3u);
  constexpr size_t kNumMethods = 5, kNumThresholds = 5;
  ASSERT_EQ(sets[0].at("runs").size(), kNumMethods * (1 + kNumThresholds));
  for (const nlohmann::json& measured : sets[0].at("runs")) ExpectFiguresOfCommand(measured);
  for (size_t i = 0; i < kNumMethods; ++i) {  // with default options
    const nlohmann::json& method = sets[0].at("runs")[i];
    EXPECT_TRUE(method.at("threshold").is_null());
    const nlohmann::json& rows = method.at("truth").at("all").at("rows");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_GT(rows[1].at("precision"), 0.3) << method.at("method");
    EXPECT_GT(rows[1].at("recall"), 0.05) << method.at("method");
    EXPECT_GE(rows[1].at("links_per_chain"), 1.0) << method.at("method");
    EXPECT_LT(rows[1].at("f_low"), rows[1].at("f_high")) << method.at("method");
    const bool is_drawing = method.at("method").get<std::string>().ends_with("drawing");
    EXPECT_EQ(method.at("sigmas").is_null(), !is_drawing) << method.at("method");
    if (is_drawing) {
      EXPECT_GT(method.at("sigmas").at("all").at("num_inliers"), 50) << method.at("method");
    }
    EXPECT_GE(method.at("shape").at("saw_teeth").at("median"), 1.0) << method.at("method");
    EXPECT_GT(method.at("held_out").at("to_edgels").at("count"), 100) << method.at("method");
    EXPECT_LT(method.at("held_out").at("to_edgels").at("median_px"), 2.0) << method.at("method");
  }
  EXPECT_TRUE(std::filesystem::exists(dir / "sample-day" / "default-drawing.json"));
  EXPECT_THAT(ReadText(dir / "report.md"), HasSubstr("Circles and crossings of the truth"));
  ExpectPageOfResults(dir.path());
}

void WriteText(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

void AddSamplePhotographs(const std::filesystem::path& data_set) {
  std::filesystem::create_directories(data_set);
  for (const char* folder : {"images", "sparse"}) {
    std::filesystem::create_directory_symlink(
        std::filesystem::path(LIMN_SAMPLE_DIR) / "day" / folder, data_set / folder);
  }
}

// A data set of <dir>/data, to <dir>/out.
LimnRun MeasureQuickly(const TempDir& dir, const std::string& set) {
  return RunProgram(QUALITY_REPORT_PROGRAM,
                    {"--data_path", (dir / "data").string(), "--sets", set, "--quick", "1",
                     "--output_path", (dir / "out").string(), "--max_image_size", "160"});
}

// The sample scene's photographs in the place of the vase, with a truth of points and the result of
// one of the two programs.
TEST(QualityReport, ShowsStoredResultsOfOtherPrograms) {
  const TempDir dir;
  AddSamplePhotographs(dir / "data/vase");
  WriteText(dir / "data/vase/ground_truth/vase-edge-gt3-017.txt.gz", "0 0 0\n0.1 0 0\n0.2 0 0\n");
  WriteText(dir / "data/peers/line3dpp-vase.obj.gz", "v 0 0 0\nv 0.1 0 0\nl 1 2\n");
  const LimnRun run = MeasureQuickly(dir, "vase");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json set = ReadJson(dir / "out/report.json").at("sets").at(0);
  ASSERT_EQ(set.at("peers").size(), 1u);
  const nlohmann::json& peer = set.at("peers")[0];
  EXPECT_EQ(peer.at("method"), "Line3D++");
  EXPECT_EQ(peer.at("shape").at("num_links"), 1);
  const nlohmann::json& row = peer.at("truth").at("all").at("rows").at(2);  // tau = 0.002
  EXPECT_NEAR(row.at("recall").get<double>(), 2.0 / 3, 1e-9);
  EXPECT_EQ(row.at("num_free_ends"), 2);
  ASSERT_EQ(set.at("missing_peers").size(), 2u);
  const std::string tables = ReadText(dir / "out/report.md");
  EXPECT_THAT(tables, HasSubstr("| Line3D++ | all |"));
  EXPECT_THAT(tables, Not(HasSubstr("Circles and crossings")));
  EXPECT_THAT(tables, HasSubstr("Left out, there is no such file: "));
  EXPECT_THAT(tables, HasSubstr("mcs-vase-pub-s50.obj.gz"));
  EXPECT_THAT(tables, HasSubstr("option-all.ply"));
}

// The sample scene in the place of the bench, with its true curves as center lines, too.
TEST(QualityReport, MeasuresRods) {
  const TempDir dir;
  const std::filesystem::path sample = LIMN_SAMPLE_DIR, bench = dir / "data/bench";
  AddSamplePhotographs(bench);
  std::filesystem::copy(sample / "truth", bench / "truth");
  std::filesystem::copy(sample / "truth/curves.ply", bench / "truth/rods.ply");
  const LimnRun run = MeasureQuickly(dir, "bench");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json set = ReadJson(dir / "out/report.json").at("sets").at(0);
  for (const nlohmann::json& method : set.at("runs")) {
    const bool is_drawing = method.at("method").get<std::string>().ends_with("drawing");
    ASSERT_EQ(method.at("rods").is_null(), !is_drawing) << method.at("method");
    if (!is_drawing) continue;
    ASSERT_EQ(method.at("rods").at("all").size(), 3u);
    EXPECT_GT(method.at("rods").at("all").at(1).at("true_length"), 10);  // m
  }
  EXPECT_THAT(ReadText(dir / "out/report.md"), HasSubstr("| default drawing | all | "));
}

TEST(QualityReport, RefusesUnknownSets) {
  const TempDir dir;
  const LimnRun run =
      RunProgram(QUALITY_REPORT_PROGRAM, {"--sets", "moon", "--output_path", dir.path().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: sets = moon: must be among"));
  EXPECT_THAT(run.err, HasSubstr("sample-day"));
  EXPECT_TRUE(ReadTree(dir.path()).empty());
}

}  // namespace
}  // namespace limn::testing
