// The quality report on one small data set: every figure is there.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

nlohmann::json ReadJson(const std::filesystem::path& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

TEST(QualityReport, MeasuresEveryMethod) {
  const TempDir dir;
  const LimnRun run =
      RunProgram(QUALITY_REPORT_PROGRAM, {"--sets", "sample-day", "--quick", "1", "--output_path",
                                          dir.path().string(), "--max_image_size", "160"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json sets = ReadJson(dir / "report.json").at("sets");
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].at("name"), "sample-day");
  EXPECT_EQ(sets[0].at("num_held_out"), 2);
  EXPECT_EQ(sets[0].at("ceiling").at("all").size(), 3u);
  EXPECT_EQ(sets[0].at("runs").size(), 6u);
  for (const nlohmann::json& method : sets[0].at("runs")) {
    const nlohmann::json& rows = method.at("truth").at("all").at("rows");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_GT(rows[1].at("precision"), 0.3) << method.at("method");
    EXPECT_GT(rows[1].at("recall"), 0.05) << method.at("method");
    const bool is_drawing = method.at("method").get<std::string>().ends_with("drawing");
    EXPECT_EQ(method.at("sigmas").is_null(), !is_drawing) << method.at("method");
    if (is_drawing) {
      EXPECT_GT(method.at("sigmas").at("all").at("num_inliers"), 50) << method.at("method");
    }
    EXPECT_GE(method.at("shape").at("saw_teeth").at("median"), 1.0) << method.at("method");
    EXPECT_GT(method.at("held_out").at("to_edgels").at("count"), 100) << method.at("method");
    EXPECT_LT(method.at("held_out").at("to_edgels").at("median_px"), 2.0) << method.at("method");
  }
  EXPECT_TRUE(std::filesystem::exists(dir / "sample-day" / "refined-drawing.json"));
  EXPECT_TRUE(std::filesystem::exists(dir / "report.md"));
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
