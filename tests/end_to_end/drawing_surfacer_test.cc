// SPDX-License-Identifier: BSD-3-Clause
// The faces of the drawing of some small images.
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class DrawingSurfacer : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new SmallScene;
    const LimnRun run = RunLimn(scene_->Arguments());
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  static void TearDownTestSuite() { delete scene_; }

  // Of the scene's drawing, into a folder of the test's own.
  LimnRun Find(const std::string& output, const std::vector<std::string>& more = {}) const {
    return Run("drawing_surfacer", output, more);
  }

  LimnRun Run(const std::string& command, const std::string& output,
              const std::vector<std::string>& more) const {
    std::vector<std::string> arguments =
        scene_->Arguments({"--drawing_path", (*scene_ / "drawing.json").string()});
    arguments[0] = command;
    *(std::ranges::find(arguments, "--output_path") + 1) = (dir_ / output).string();
    for (size_t i = 0; i + 1 < more.size(); i += 2) {
      const auto given = std::ranges::find(arguments, more[i]);
      if (given != arguments.end()) {
        *(given + 1) = more[i + 1];
      } else {
        arguments.insert(arguments.end(), {more[i], more[i + 1]});
      }
    }
    return RunLimn(arguments);
  }

  DrawingGraph Result(const std::string& output) const {
    return ReadDrawingJson((dir_ / output / "drawing.json").string()).graph;
  }

  static SmallScene* scene_;
  TempDir dir_;
};
SmallScene* DrawingSurfacer::scene_ = nullptr;

TEST_F(DrawingSurfacer, AddsFacesAndLeavesTheRestAsItWas) {
  const LimnRun run = Find("out", {"--log_level", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* name :
       {"drawing.ply", "drawing.obj", "curves/tracks.txt", "curves/overlays/view_03.jpg.png"}) {
    EXPECT_TRUE(fs::exists(dir_ / "out" / name)) << name;
  }
  const DrawingGraph given = ReadDrawingJson((*scene_ / "drawing.json").string()).graph;
  const DrawingGraph found = Result("out");  // validated by the reader
  EXPECT_TRUE(given.faces.empty());
  ASSERT_FALSE(found.faces.empty());
  ASSERT_EQ(found.links.size(), given.links.size());
  for (size_t l = 0; l < given.links.size(); ++l) {
    EXPECT_EQ(found.links[l].points_in_world, given.links[l].points_in_world) << l;
    EXPECT_EQ(found.links[l].tentative, given.links[l].tentative) << l;
  }
  EXPECT_THAT(run.out, HasSubstr(std::to_string(found.faces.size()) + "  faces\n"));
  for (const DrawingFace& face : found.faces) EXPECT_GE(face.views.size(), 2u);
  // As a mesh for other programs.
  const LimnRun exported =
      RunLimn({"drawing_exporter", "--input_path", (dir_ / "out/drawing.json").string(),
               "--output_type", "faces", "--output_path", (dir_ / "faces.ply").string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_TRUE(fs::exists(dir_ / "faces.ply"));
}

TEST_F(DrawingSurfacer, ThreadsAndFacesThatWereThereDoNotMatter) {
  ASSERT_EQ(Find("two").exit_code, 0);
  ASSERT_EQ(Find("one", {"--num_threads", "1"}).exit_code, 0);
  const std::map<std::string, std::string> two = Results(dir_ / "two");
  EXPECT_TRUE(Results(dir_ / "one") == two);
  ASSERT_EQ(Find("again", {"--drawing_path", (dir_ / "two/drawing.json").string()}).exit_code, 0);
  EXPECT_TRUE(Results(dir_ / "again") == two);
}

TEST_F(DrawingSurfacer, OptionsMatter) {
  ASSERT_EQ(Find("default").exit_code, 0);
  ASSERT_EQ(
      Find("strict", {"--Surfaces.min_views", "6", "--Surfaces.min_seen_share", "1"}).exit_code, 0);
  EXPECT_LT(Result("strict").faces.size(), Result("default").faces.size());
  // Another drawing is not replaced unasked.
  const LimnRun refused = Find("default", {"--Surfaces.min_views", "3"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--overwrite 1"));
  EXPECT_EQ(Find("default", {"--Surfaces.min_views", "3", "--overwrite", "1"}).exit_code, 0);
}

TEST_F(DrawingSurfacer, FacesEndWhereLinksMove) {
  ASSERT_EQ(Find("found").exit_code, 0);
  const size_t num_faces = Result("found").faces.size();
  const std::string found = (dir_ / "found/drawing.json").string();
  for (const std::string command : {"drawing_regularizer", "drawing_refiner"}) {
    const LimnRun run = Run(command, command, {"--drawing_path", found});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_LT(Result(command).faces.size(), num_faces);
    EXPECT_THAT(run.out, HasSubstr("WARNING: links have moved: of " + std::to_string(num_faces) +
                                   " faces between them "));
  }
  EXPECT_TRUE(Result("drawing_refiner").faces.empty());
}

TEST_F(DrawingSurfacer, BadOptionsWriteNothing) {
  for (const auto& [option, value] :
       std::map<std::string, std::string>{{"--Surfaces.min_views", "0"},
                                          {"--Surfaces.min_shown_share", "1.5"},
                                          {"--Surfaces.plane_tolerance_px", "0"},
                                          {"--Surfaces.max_bridge_px", "far"},
                                          {"--drawing_path", (dir_ / "missing.json").string()}}) {
    const LimnRun run = Find("out", {option, value});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), HasSubstr(value)));
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_TRUE(ReadTree(dir_.path()).empty());
  }
}

}  // namespace
}  // namespace limn::testing
