// SPDX-License-Identifier: BSD-3-Clause
// Edges from elsewhere: --edges_path, and the files that edge_extractor and curve_linker write.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class GivenEdgesRun : public ::testing::Test {
 protected:
  GivenEdgesRun() {
    std::string names;
    for (int i = 0; i < kNumImages; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
    list_ = dir_.WriteFile("list.txt", names);
  }

  LimnRun Run(const std::string& command, const std::string& output,
              const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {
        command, "--workspace_path", workspace_, "--output_path", Path(output), "--image_list_path",
        list_,   "--mask_path",      masks_,     "--quality",     "low",        "--max_image_size",
        "240"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  void ExpectRun(const std::string& command, const std::string& output,
                 const std::vector<std::string>& more = {}) const {
    const LimnRun run = Run(command, output, more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }

  std::string Path(const std::string& name) const { return (dir_ / name).string(); }

  // All that is drawn: no options, no times, no stored results.
  std::map<std::string, std::string> Drawn(const std::string& output) const {
    auto files = ReadTree(dir_ / output);
    std::erase_if(files, [](const auto& file) {
      return file.first.starts_with("curves/cache") || file.first == "curves/project.ini" ||
             file.first == "drawing.html";
    });
    return files;
  }

  // The drawing from files of edges is that from the photographs.
  void ExpectRoundTrip(const std::string& extractor_of_fragments) const {
    ExpectRun("automatic_drawer", "own");
    const auto own = Drawn("own");
    ASSERT_GT(ReadDrawingJson(Path("own/drawing.json")).graph.links.size(), 5u);

    ExpectRun("edge_extractor", "files", {"--format", "edg"});
    ExpectRun("automatic_drawer", "edg", {"--edges_path", Path("files/curves/edges")});
    EXPECT_EQ(Drawn("edg"), own);

    ExpectRun(extractor_of_fragments, "files", {"--format", "cem"});
    ExpectRun("automatic_drawer", "cem", {"--edges_path", Path("files/curves/fragments")});
    EXPECT_EQ(Drawn("cem"), own);
  }

  static constexpr int kNumImages = 6;
  TempDir dir_;
  std::string list_;
  std::string workspace_ = LIMN_SAMPLE_DIR "/day";
  std::string masks_;  // empty = none
};

TEST_F(GivenEdgesRun, OwnEdgesReadBackGiveTheSameBytes) { ExpectRoundTrip("curve_linker"); }

// The masks hide a corner of every image.
TEST_F(GivenEdgesRun, OwnEdgesBeforeALensAndOutsideMasksToo) {
  workspace_ = LIMN_SAMPLE_DIR "/distorted";
  masks_ = Path("masks");
  std::string mask = "P5\n640 480\n255\n" + std::string(640 * 480, '\xff');
  for (int y = 0; y < 160; ++y) mask.replace(mask.size() - (y + 1) * 640, 300, 300, '\0');
  for (int i = 0; i < kNumImages; ++i) {
    dir_.WriteFile("masks/view_0" + std::to_string(i) + ".jpg.png", mask);
  }
  ExpectRoundTrip("edge_extractor");
}

TEST_F(GivenEdgesRun, ChangedFilesAreReadAgain) {
  ExpectRun("edge_extractor", "files", {"--format", "edg"});
  const std::vector<std::string> given = {"--edges_path", Path("files/curves/edges")};
  ExpectRun("curve_linker", "out", given);
  EXPECT_THAT(Run("curve_linker", "out", given).out,
              HasSubstr("image curves of 6 images were taken from the cache"));
  std::ofstream(Path("files/curves/edges/view_02.jpg.edg"))
      << "# EDGE_MAP v3.0\n\nWIDTH=240\nHEIGHT=180\nEDGE_COUNT=0\n";
  const LimnRun again = Run("curve_linker", "out", given);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, AllOf(HasSubstr("of 5 images were taken from the cache"),
                               Not(HasSubstr("of 6 images were taken from the cache"))));
}

TEST_F(GivenEdgesRun, BadFilesEndTheRun) {
  ExpectRun("edge_extractor", "files", {"--format", "edg"});
  const std::string edges = Path("files/curves/edges");
  const auto error_of = [&](const std::string& folder) {
    const LimnRun run = Run("automatic_drawer", "out", {"--edges_path", folder});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(fs::exists(Path("out/drawing.json")));
    return run.err;
  };
  std::ofstream(edges + "/view_02.jpg.edg")
      << "# EDGE_MAP v3.0\n\nWIDTH=240\nHEIGHT=180\nEDGE_COUNT=1\n[1, 1] 0 1 [nan, 1] 0 1 0\n";
  EXPECT_THAT(error_of(edges), HasSubstr("view_02.jpg.edg: line 6: edgel not finite"));
  fs::remove(edges + "/view_02.jpg.edg");
  EXPECT_THAT(error_of(edges), HasSubstr("edges: has no edges of 1 of 6 images (view_02.jpg)"));
  EXPECT_THAT(error_of(Path("nowhere")), HasSubstr("nowhere: no such folder (edges_path)"));
}

TEST_F(GivenEdgesRun, OutputsDoNotReplaceTheirInputs) {
  ExpectRun("edge_extractor", "out", {"--format", "edg"});
  const auto before = ReadTree(dir_ / "out/curves/edges");
  const LimnRun run =
      Run("edge_extractor", "out", {"--format", "edg", "--edges_path", Path("out/curves/edges")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("view_00.jpg.edg: would be replaced, but is an input"));
  EXPECT_EQ(ReadTree(dir_ / "out/curves/edges"), before);
}

TEST_F(GivenEdgesRun, FilesOfOthersStayUnlessOverwrite) {
  dir_.WriteFile("out/curves/edges/view_01.jpg.edg", "my edges\n");
  LimnRun run = Run("edge_extractor", "out", {"--format", "edg"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("view_01.jpg.edg: exists, and was not made by limn"));
  EXPECT_EQ(ReadTree(dir_ / "out/curves/edges").size(), 1u);
  ExpectRun("edge_extractor", "out", {"--format", "edg", "--overwrite", "1"});
  ExpectRun("edge_extractor", "out", {"--format", "edg"});
  ExpectRun("curve_linker", "out", {"--format", "cem"});
  ExpectRun("curve_linker", "out", {"--format", "cem"});
}

// No edges give no drawing, while the photographs would.
TEST_F(GivenEdgesRun, TilesAreDrawnFromThem) {
  for (int i = 0; i < kNumImages; ++i) {
    dir_.WriteFile("none/view_0" + std::to_string(i) + ".txt", "# none\n");
  }
  std::vector<std::string> options = {"--Tiles.max_views", "5", "--Tiles.reach_px", "20"};
  ExpectRun("automatic_drawer", "own", options);
  EXPECT_FALSE(ReadDrawingJson(Path("own/drawing.json")).graph.links.empty());
  options.insert(options.end(), {"--edges_path", Path("none")});
  ExpectRun("automatic_drawer", "out", options);
  EXPECT_TRUE(ReadDrawingJson(Path("out/drawing.json")).graph.links.empty());
}

TEST_F(GivenEdgesRun, SegmentsAreDrawnWithoutLinking) {
  fs::create_directories(dir_ / "lines");
  for (int i = 0; i < kNumImages; ++i) {
    dir_.WriteFile("lines/view_0" + std::to_string(i) + ".txt", "# none\n100 100 200 120\n");
  }
  ExpectRun("curve_linker", "out", {"--edges_path", Path("lines"), "--format", "cem"});
  std::ifstream cem(Path("out/curves/fragments/view_00.jpg.cem"));
  const std::string text{std::istreambuf_iterator<char>(cem), std::istreambuf_iterator<char>()};
  EXPECT_THAT(text, HasSubstr("[Contours]\ncount=1\n"));
}

}  // namespace
}  // namespace limn::testing
