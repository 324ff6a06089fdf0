// SPDX-License-Identifier: BSD-3-Clause
// The measurements of time and memory on little scenes: every figure is there, and reports of two
// commits can be compared.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

nlohmann::json ReadJson(const fs::path& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

std::vector<std::string> StageNames(const nlohmann::json& set) {
  std::vector<std::string> names;
  for (const auto& stage : set.at("stages")) names.push_back(stage.at("stage"));
  return names;
}

TEST(StageReport, TellsEveryStageAndIsComparable) {
  const TempDir dir;
  const LimnRun run = RunProgram(STAGE_REPORT_PROGRAM,
                                 {"--sets", "sample-day", "--repeat", "2", "--commit", "abc",
                                  "--output_path", dir.path().string(), "--max_image_size", "160"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json report = ReadJson(dir / "report.json");
  EXPECT_EQ(report.at("format"), "limn stages 2");
  EXPECT_EQ(report.at("commit"), "abc");
  ASSERT_EQ(report.at("sets").size(), 1u);
  const nlohmann::json& set = report.at("sets")[0];
  EXPECT_EQ(set.at("num_views"), 24);
  EXPECT_THAT(StageNames(set),
              ElementsAre("image curves", "swept sketch", "drawing", "refinement", "belief", "rods",
                          "outlines of smooth bodies", "primitives", "kinds of edges", "texture",
                          "short curves", "total"));
  double seconds = 0;
  std::vector<std::string> with_truth;
  for (const nlohmann::json& stage : set.at("stages")) {
    const bool is_total = stage.at("stage") == "total";
    for (const char* key : {"seconds", "cpu_seconds", "peak_mb"}) {
      EXPECT_EQ(stage.at(key).size(), 2u) << stage;
    }
    EXPECT_GT(stage.at("peak_mb")[1], 1) << stage;
    if (!is_total) seconds += stage.at("seconds")[1].get<double>();
    if (stage.at("truth").is_null()) continue;
    with_truth.push_back(stage.at("stage"));
    ASSERT_EQ(stage.at("truth").at("all").size(), 3u);
    EXPECT_GT(stage.at("truth").at("all")[2].at("precision"), 0.3) << stage;
  }
  EXPECT_THAT(with_truth,
              ElementsAre("swept sketch", "drawing", "outlines of smooth bodies", "short curves"));
  EXPECT_NEAR(set.at("stages").back().at("seconds")[1].get<double>(), seconds, 1e-6);
  EXPECT_TRUE(fs::exists(dir / "report.md"));

  // As a section of datasets/RESULTS.md.
  std::ofstream(dir / "colmap.md") << "| limn over both of COLMAP's | 0.50 | 0.75 | |\n";
  const LimnRun section = RunProgram(
      "/usr/bin/python3", {LIMN_SOURCE_DIR "/scripts/bench/costs_section.py",
                           (dir / "report.json").string(), (dir / "colmap.md").string()});
  ASSERT_EQ(section.exit_code, 0) << section.err;
  EXPECT_THAT(section.out, HasSubstr("at commit abc"));
  EXPECT_THAT(section.out, HasSubstr("|  | sample-day |\n| --- | --- |\n| views | 24 |\n"));
  EXPECT_THAT(section.out, HasSubstr("| limn over both of COLMAP's | 0.50 |"));

  // Beside itself.
  fs::create_directories(dir / "pair");
  for (const char* name : {"a-1.json", "b-1.json"}) {
    fs::copy(dir / "report.json", dir / "pair" / name);
  }
  const LimnRun comparison =
      RunProgram("/usr/bin/python3",
                 {LIMN_SOURCE_DIR "/scripts/bench/compare_reports.py", (dir / "pair").string()});
  ASSERT_EQ(comparison.exit_code, 0) << comparison.err;
  EXPECT_THAT(comparison.out, HasSubstr("A = abc, B = abc, 1 runs each"));
  EXPECT_THAT(comparison.out, HasSubstr("| sample-day | total |"));
  EXPECT_THAT(comparison.out, HasSubstr("1.000 (1.000 to 1.000)"));
  EXPECT_THAT(comparison.out, HasSubstr("+0.0 / +0.0 / +0.0;"));
}

// Noise-free edgels of smooth curves that nothing hides: nearly all is found, nothing else is.
TEST(LargeScene, IsDrawn) {
  const TempDir dir;
  const LimnRun run = RunProgram(LARGE_SCENE_PROGRAM, {"--views", "16", "--edgels", "600",
                                                       "--output_path", dir.path().string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json set = ReadJson(dir / "report.json").at("sets")[0];
  EXPECT_EQ(set.at("num_views"), 16);
  const nlohmann::json& drawn = set.at("stages")[1];
  EXPECT_EQ(drawn.at("stage"), "drawing");
  const nlohmann::json& row = drawn.at("truth").at("all")[1];
  EXPECT_GT(row.at("precision"), 0.95);
  EXPECT_GT(row.at("recall"), 0.8);
}

TEST(StageReport, RefusesNoRuns) {
  const TempDir dir;
  const LimnRun run =
      RunProgram(STAGE_REPORT_PROGRAM, {"--repeat", "0", "--output_path", (dir / "out").string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: repeat = 0: must be >= 1"));
  EXPECT_TRUE(ReadTree(dir.path()).empty());
}

}  // namespace
}  // namespace limn::testing
