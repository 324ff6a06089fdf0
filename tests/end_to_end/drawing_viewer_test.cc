// SPDX-License-Identifier: BSD-3-Clause
// drawing_viewer on the sample scene with a drawing of one link: what it finds, writes and refuses.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class DrawingViewer : public ::testing::Test {
 protected:
  static std::string Drawing(const std::string& views) {
    return R"({"format": "limn-drawing", "format_version": 1, "views": [)" + views +
           R"(], "options": {}, "nodes": [
        {"id": 0, "position": [0, 0, 2], "kind": "end", "degree": 1, "incident": [[0, 0]],
         "continuations": []},
        {"id": 1, "position": [1, 0, 2], "kind": "end", "degree": 1, "incident": [[0, 1]],
         "continuations": []}],
      "links": [{"id": 0, "node0": 0, "node1": 1, "closed": false, "length": 1, "residual_px": 0.5,
        "supporting_views": [], "members": [], "points": [[0, 0, 2], [1, 0, 2]],
        "sigma": [0.1, 0.1]}]})";
  }

  static std::string AllViews() {
    std::string names;
    for (int v = 0; v < 24; ++v) {
      names += std::string(v == 0 ? "" : ", ") + "\"view_" + (v < 10 ? "0" : "") +
               std::to_string(v) + ".jpg\"";
    }
    return names;
  }

  void Write(const std::string& name, const std::string& text) {
    std::ofstream(dir_ / name) << text;
  }

  LimnRun Run(std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"drawing_viewer", "--workspace_path",
                                          std::string(LIMN_SAMPLE_DIR) + "/day", "--output_path",
                                          dir_.path().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  void ExpectRefused(const std::vector<std::string>& more, const auto& line_matcher) {
    const auto before = ReadTree(dir_.path());
    const LimnRun run = Run(more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), line_matcher));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(ReadTree(dir_.path()), before);
  }

  TempDir dir_;
};

TEST_F(DrawingViewer, WritesAPageTheSameEveryTime) {
  Write("drawing.json", Drawing(AllViews()));
  const LimnRun run = Run({"--num_threads", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1 links, 24 photographs, 1500 points"));
  const auto first = ReadTree(dir_.path());
  ASSERT_EQ(Run({"--num_threads", "2"}).exit_code, 0);
  EXPECT_EQ(ReadTree(dir_.path()), first);
  EXPECT_THAT(first.at("drawing.html"), StartsWith("<!doctype html>"));
}

TEST_F(DrawingViewer, ThinsTheCloudAndLeavesItOut) {
  Write("drawing.json", Drawing(AllViews()));
  EXPECT_THAT(Run({"--max_points", "700"}).out, HasSubstr(" 700 points"));
  EXPECT_THAT(Run({"--cloud", "none"}).out, HasSubstr(" 0 points"));
}

TEST_F(DrawingViewer, ShowsTheFusedDrawingUnlessItIsOlder) {
  Write("drawing.json", Drawing(AllViews()));
  Write("drawing-fused.json", Drawing(AllViews()));
  const auto now = fs::last_write_time(dir_ / "drawing.json");
  fs::last_write_time(dir_ / "drawing-fused.json", now + std::chrono::seconds(5));
  EXPECT_THAT(Run().out, HasSubstr("drawing-fused.json\n"));
  fs::last_write_time(dir_ / "drawing-fused.json", now - std::chrono::seconds(5));
  EXPECT_THAT(Run().out, HasSubstr("/drawing.json\n"));
}

TEST_F(DrawingViewer, RefusesBadInput) {
  ExpectRefused({}, HasSubstr("drawing.json"));  // there is none
  Write("drawing.json", Drawing("\"other.jpg\""));
  ExpectRefused({}, HasSubstr("is a drawing of other images"));
  Write("drawing.json", Drawing(AllViews()));
  ExpectRefused({"--cloud", "dense"}, HasSubstr("no dense cloud"));
  ExpectRefused({"--cloud", "some"}, HasSubstr("cloud = some"));
  ExpectRefused({"--thumbnail_size", "4"}, HasSubstr("thumbnail_size"));
  ExpectRefused({"--max_points", "-1"}, HasSubstr("max_points = -1"));
  Write("report.json", "[1, 2]");
  const std::string report = (dir_ / "report.json").string();
  ExpectRefused({"--report_path", report}, AllOf(HasSubstr("report.json"), HasSubstr("object")));
  Write("report.json", "{\"title\": ");
  ExpectRefused({"--report_path", report}, HasSubstr("report.json"));
}

}  // namespace
}  // namespace limn::testing
