// SPDX-License-Identifier: BSD-3-Clause
// What becomes of drawing.html when a command writes the drawing that it shows.
#include <chrono>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/viewer/page_reader.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// A drawing with its page, made once; every test works on a copy.
class PageRenewal : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!HasViewerPage()) return;
    drawn_ = new SmallScene();
    const LimnRun run = RunLimn(drawn_->Arguments());
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  static void TearDownTestSuite() {
    delete drawn_;
    drawn_ = nullptr;
  }

  void SetUp() override {
    if (!HasViewerPage()) GTEST_SKIP() << "built without the viewer";
    fs::copy(drawn_->output(), scene_.output(), fs::copy_options::recursive);
  }

  LimnRun Run(const std::string& command, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = scene_.Arguments({"--overwrite", "1"});
    if (command == "drawing_aligner") arguments = scene_.Arguments();
    arguments[0] = command;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  std::string Page() const { return (scene_ / "drawing.html").string(); }

  nlohmann::json Header() const {
    const LimnRun read = RunProgram(
        "/usr/bin/python3", {LIMN_SOURCE_DIR "/tests/scripts/readers/read_page.py", Page()});
    EXPECT_EQ(read.exit_code, 0) << read.err;
    return nlohmann::json::parse(read.out);
  }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(scene_ / name) << text;
  }

  static int CountWarnings(const std::string& text) {
    int count = 0;
    for (size_t at = text.find("was not renewed"); at != std::string::npos;
         at = text.find("was not renewed", at + 1)) {
      ++count;
    }
    return count;
  }

  // The command works, leaves the page as it is and warns of it once.
  void ExpectLeft(const std::string& page, const std::string& reason) const {
    const LimnRun run = Run("drawing_aligner");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out,
                AllOf(HasSubstr("WARNING: " + Page() + " is older than the drawing"),
                      HasSubstr("renewed (" + reason), HasSubstr("drawing_viewer makes it anew")));
    EXPECT_EQ(CountWarnings(run.out), 1) << run.out;
    EXPECT_TRUE(ReadDrawingJson((scene_ / "drawing.json").string()).metadata.alignment.has_value());
    EXPECT_TRUE(ReadTree(scene_.output()).at("drawing.html") == page);
  }

  SmallScene scene_;

 private:
  static SmallScene* drawn_;
};

SmallScene* PageRenewal::drawn_ = nullptr;

TEST_F(PageRenewal, KeepsReportPointsAndPhotographs) {
  const StoredPage before = ReadViewerPage(Page());
  const auto header_before = Header();
  ASSERT_EQ(before.photos.size(), 6u);
  ASSERT_FALSE(before.cloud.empty());
  EXPECT_EQ(header_before.at("zIsUp"), false);
  const LimnRun run = Run("drawing_regularizer");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("wrote " + Page()), Not(HasSubstr("WARNING: " + Page()))));
  const StoredPage after = ReadViewerPage(Page());
  const auto header = Header();
  EXPECT_EQ(after.report_json, before.report_json);
  EXPECT_EQ(header.at("report").at("drawing"), header_before.at("drawing").at("fingerprint"));
  EXPECT_NE(header.at("drawing").at("fingerprint"), header_before.at("drawing").at("fingerprint"));
  EXPECT_EQ(header.at("drawing").at("name"), "drawing.json");
  ASSERT_EQ(after.photos.size(), before.photos.size());
  for (size_t i = 0; i < after.photos.size(); ++i) {
    EXPECT_EQ(after.photos[i].thumbnail.jpeg, before.photos[i].thumbnail.jpeg);
  }
  ASSERT_EQ(after.cloud.size(), before.cloud.size());
  for (size_t i = 0; i < after.cloud.size(); ++i) {
    EXPECT_LT((after.cloud[i].position - before.cloud[i].position).norm(), 1e-3);
  }
  EXPECT_EQ(header.at("nodes").size(),
            ReadDrawingJson((scene_ / "drawing.json").string()).graph.nodes.size());
}

TEST_F(PageRenewal, EveryCommandDoesIt) {
  Write("edits.json", R"({"format": "limn_edits", "format_version": 1, "edits": []})");
  const std::string edits = (scene_ / "edits.json").string();
  std::string fingerprint = Header().at("drawing").at("fingerprint");
  const std::vector<std::vector<std::string>> commands = {{"drawing_aligner"},
                                                          {"drawing_surfacer"},
                                                          {"drawing_editor", "--edits", edits},
                                                          {"drawing_refiner"},
                                                          {"curve_drawer", "--mode", "sweep"}};
  for (const std::vector<std::string>& command : commands) {
    const LimnRun run = Run(command[0], {command.begin() + 1, command.end()});
    ASSERT_EQ(run.exit_code, 0) << command[0] << run.err;
    const auto header = Header();
    EXPECT_NE(header.at("drawing").at("fingerprint"), fingerprint) << command[0];
    EXPECT_FALSE(header.at("report").at("stages").empty()) << command[0];
    fingerprint = header.at("drawing").at("fingerprint");
  }
}

TEST_F(PageRenewal, ShowsTheWorldOfAnAlignedDrawing) {
  const StoredPage before = ReadViewerPage(Page());
  ASSERT_EQ(Run("drawing_aligner", {"--known_length", "link 0 = 2 m"}).exit_code, 0);
  const auto header = Header();
  EXPECT_EQ(header.at("zIsUp"), true);
  EXPECT_EQ(header.at("unit"), "m");
  const auto drawing = ReadDrawingJson((scene_ / "drawing.json").string());
  EXPECT_EQ(header.at("shownFromModel").at("scale").get<double>(),
            drawing.metadata.alignment->world_from_model.scale);
  // Points of the old page were in the model's coordinates, and come back to them.
  const StoredPage after = ReadViewerPage(Page());
  ASSERT_EQ(after.cloud.size(), before.cloud.size());
  EXPECT_LT((after.cloud[0].position - before.cloud[0].position).norm(), 1e-3);
  // The commands take photographs at different sizes.
  EXPECT_EQ(after.photos[0].thumbnail.jpeg, before.photos[0].thumbnail.jpeg);
  // Whoever asks for the coordinates of the model goes on to see them.
  ASSERT_EQ(Run("drawing_viewer", {"--aligned", "0", "--thumbnail_size", "100"}).exit_code, 0);
  EXPECT_EQ(Header().at("zIsUp"), false);
  EXPECT_FALSE(Header().at("report").is_null()) << "the report is that of the page before";
  const std::string small = ReadViewerPage(Page()).photos[0].thumbnail.jpeg;
  EXPECT_LT(small.size(), before.photos[0].thumbnail.jpeg.size() / 2);
  ASSERT_EQ(Run("drawing_aligner").exit_code, 0);
  EXPECT_EQ(Header().at("zIsUp"), false);
  EXPECT_EQ(ReadViewerPage(Page()).photos[0].thumbnail.jpeg, small);
}

TEST_F(PageRenewal, ShowsTheNewerOfTwoDrawings) {
  const auto later = fs::last_write_time(scene_ / "drawing.json") + std::chrono::seconds(100);
  fs::copy(scene_ / "drawing.json", scene_ / "drawing-fused.json");
  fs::last_write_time(scene_ / "drawing-fused.json", later);
  ASSERT_EQ(Run("drawing_aligner").exit_code, 0);
  EXPECT_EQ(Header().at("drawing").at("name"), "drawing-fused.json");
  fs::last_write_time(scene_ / "drawing-fused.json", later - std::chrono::hours(1));
  ASSERT_EQ(Run("drawing_aligner").exit_code, 0);
  EXPECT_EQ(Header().at("drawing").at("name"), "drawing.json");
}

TEST_F(PageRenewal, NewPhotographsAreTakenWhereTheOldOnesDoNotFit) {
  const StoredPage before = ReadViewerPage(Page());
  // A page of other images, with a picture under a name that it shares with the scene.
  ViewerScene other;
  other.views.resize(2);
  other.thumbnails.resize(2);
  for (size_t v = 0; v < 2; ++v) {
    other.views[v].name = v == 0 ? "other.jpg" : "view_01.jpg";
    other.views[v].camera = {700, 700, 10, 20, 640, 480};
    other.thumbnails[v].jpeg = "not the photograph";
  }
  std::ofstream out(Page());
  WriteViewerPage(other, out);
  out.close();
  ASSERT_EQ(Run("drawing_regularizer").exit_code, 0);
  const StoredPage after = ReadViewerPage(Page());
  ASSERT_EQ(after.photos.size(), 6u);
  for (const PagePhoto& photo : after.photos) {
    EXPECT_TRUE(photo.thumbnail.jpeg.starts_with("\xff\xd8")) << photo.name;
  }
  EXPECT_TRUE(after.report_json.empty());
}

TEST_F(PageRenewal, OtherAndDamagedFilesAreLeft) {
  const std::string whole = ReadTree(scene_.output()).at("drawing.html");
  for (const auto& [page, reason] : std::vector<std::pair<std::string, std::string>>{
           {"<!doctype html><p>my notes</p>", "is not a page of limn"},
           {whole.substr(0, whole.find("id=\"payload\"") + 1000), "is cut off"}}) {
    Write("drawing.html", page);
    ExpectLeft(page, reason);
  }
}

TEST_F(PageRenewal, WithoutAPageNoneIsMade) {
  fs::remove(Page());
  const LimnRun run = Run("drawing_regularizer");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(fs::exists(Page()));
  EXPECT_THAT(run.out, Not(HasSubstr("drawing.html")));
}

TEST_F(PageRenewal, EditsOfAnOlderPageAreTold) {
  const auto file_of = [](const std::string& fingerprint) {
    return R"({"format": "limn_edits", "format_version": 1, "drawing": {"name": "drawing.json",
        "fingerprint": ")" +
           fingerprint + R"("}, "edits": []})";
  };
  const std::string edits = (scene_ / "edits.json").string();
  Write("edits.json", file_of(Header().at("drawing").at("fingerprint")));
  const LimnRun same = Run("drawing_editor", {"--edits", edits});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, Not(HasSubstr("made in a page")));
  // The command has written drawing.json anew, with what was edited.
  const LimnRun other = Run("drawing_editor", {"--edits", edits});
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_THAT(other.out, HasSubstr("WARNING: the edits were made in a page of drawing.json"));
}

TEST_F(PageRenewal, ARunWithoutAPageSaysThatTheOldOneStays) {
  const LimnRun run = Run("automatic_drawer", {"--page", "0"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("is older than the drawing, and was not renewed (--page 0)"));
}

}  // namespace
}  // namespace limn::testing
