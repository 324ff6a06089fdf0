// The work of a run in parts: shards that know nothing of each other, tiles, and MPI processes.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/output_lock.h"
#include "end_to_end/limn_process.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/formats/atomic_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::LockMode;
using colmap_ext::OutputLock;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// All results but the options of the run, which name its folder.
std::map<std::string, std::string> ResultsOfRun(const fs::path& folder) {
  auto files = Results(folder);
  EXPECT_EQ(files.erase("curves/project.ini"), 1u);
  return files;
}

std::map<std::string, std::string> ResultsInOneGo() {
  const SmallScene scene;
  EXPECT_EQ(RunLimn(scene.Arguments()).exit_code, 0);
  return ResultsOfRun(scene.output());
}

int Count(const std::string& what, const std::string& text) {
  int count = 0;
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
  return count;
}

size_t NumFiles(const fs::path& folder) { return ReadTree(folder).size(); }

TEST(Shards, SeveralAtOnceMakeWhatOneRunMakes) {
  const SmallScene scene;
  {
    LimnProcess first(scene.Arguments({"--shard", "1/3"}));
    LimnProcess second(scene.Arguments({"--shard", "2/3"}));
    LimnProcess third(scene.Arguments({"--shard", "3/3"}));
    for (LimnProcess* shard : {&first, &second, &third}) {
      const auto end = shard->Wait();
      EXPECT_EQ(end.exit_code, 0) << end.err;
      EXPECT_THAT(end.out, HasSubstr("/3 is done, 2 of 6 images"));
    }
  }
  EXPECT_FALSE(fs::exists(scene / "drawing.json"));
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("image curves of 6 images were taken from the cache"),
                             HasSubstr("sketches of 6 views were taken from the cache")));
  EXPECT_TRUE(ResultsOfRun(scene.output()) == ResultsInOneGo());
}

TEST(Shards, OneThatIsMissingCostsItsPart) {
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments({"--shard", "2/3"})).exit_code, 0);
  EXPECT_EQ(NumFiles(scene / "curves/cache/sketch"), 2u);
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_THAT(run.out, HasSubstr("sketches of 2 views were taken from the cache"));
  EXPECT_TRUE(ResultsOfRun(scene.output()) == ResultsInOneGo());
}

TEST(Shards, OfImageCurvesReadTheirOwnImagesOnly) {
  const SmallScene scene;
  auto arguments = scene.Arguments({"--shard_stage", "curves", "--shard", "4/4"});
  const LimnRun run = RunLimn(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(NumFiles(scene / "curves/cache"), 2u);
  // More shards than images: some have nothing to do.
  arguments.back() = "1/7";
  EXPECT_EQ(RunLimn(arguments).exit_code, 0);
  EXPECT_EQ(NumFiles(scene / "curves/cache/fragments"), 2u);
}

TEST(Shards, ShareTheFolderWithShardsOnly) {
  const SmallScene scene;
  const OutputLock of_another_shard(scene / "curves", LockMode::kShared);
  EXPECT_EQ(RunLimn(scene.Arguments({"--shard", "1/6"})).exit_code, 0);
  const LimnRun whole = RunLimn(scene.Arguments());
  EXPECT_EQ(whole.exit_code, 1);
  EXPECT_THAT(whole.err, HasSubstr("in use by process"));
}

TEST(Shards, ResultsThatCannotBeKeptAreAnError) {
  const SmallScene scene;
  fs::create_directories(scene / "curves");
  WriteFileAtomically(scene / "curves/cache", "in the way");
  const LimnRun run = RunLimn(scene.Arguments({"--shard", "1/2"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot keep results"));
}

TEST(Shards, DoNotWorkForARunThatWillBeRefused) {
  const SmallScene scene;
  fs::create_directories(scene.output());
  WriteFileAtomically(scene / "drawing.json", "of somebody else");
  const LimnRun run = RunLimn(scene.Arguments({"--shard", "1/2"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("--overwrite"));
  EXPECT_EQ(NumFiles(scene.output()), 1u);
}

TEST(Shards, TheOriginalSketchHasNone) {
  const SmallScene scene;
  const LimnRun run = RunLimn(scene.Arguments({"--shard", "1/2", "--mode", "original"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("mode = original"));
}

// Many small tiles.
const std::vector<std::string> kTiles = {"--Tiles.max_views", "5", "--Tiles.reach_px", "20"};

std::vector<std::string> TilesAnd(std::vector<std::string> more) {
  more.insert(more.end(), kTiles.begin(), kTiles.end());
  return more;
}

double LengthOf(const fs::path& drawing) {
  double length = 0;
  for (const DrawingLink& link : ReadDrawingJson(drawing).graph.links) {
    length += Length(link.points_in_world);
  }
  return length;
}

TEST(Tiles, MakeOneDrawing) {
  const SmallScene scene;
  const LimnRun run = RunLimn(scene.Arguments(kTiles));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("the scene is drawn in "), HasSubstr("drawing, tile 2/"),
                             HasSubstr("joining tiles"), HasSubstr("primitives")));
  EXPECT_FALSE(fs::exists(scene / "curves/swept-sketch.bin"));
  const SmallScene in_one_piece;
  ASSERT_EQ(RunLimn(in_one_piece.Arguments()).exit_code, 0);
  EXPECT_GT(LengthOf(scene / "drawing.json"), 0.6 * LengthOf(in_one_piece / "drawing.json"));
  EXPECT_LT(LengthOf(scene / "drawing.json"), 1.2 * LengthOf(in_one_piece / "drawing.json"));
}

TEST(Tiles, ThatAreKeptAreNotDrawnAgain) {
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments(kTiles)).exit_code, 0);
  const auto first = ResultsOfRun(scene.output());
  const LimnRun again = RunLimn(scene.Arguments(kTiles));
  EXPECT_THAT(again.out, HasSubstr(" tiles were taken from the cache"));
  EXPECT_THAT(again.out, Not(HasSubstr("drawing, tile 1/")));
  EXPECT_TRUE(ResultsOfRun(scene.output()) == first);
  // Damaged, one is drawn again.
  const fs::path kept = scene / "curves/cache/drawing/tile-2.bin";
  fs::resize_file(kept, fs::file_size(kept) / 2);
  const LimnRun mended = RunLimn(scene.Arguments(kTiles));
  EXPECT_THAT(mended.out, AllOf(HasSubstr("tiles in the cache could not be used"),
                                HasSubstr("drawing, tile 2/"), Not(HasSubstr("drawing, tile 1/"))));
  EXPECT_TRUE(ResultsOfRun(scene.output()) == first);
}

TEST(Tiles, AreSharedOutToShards) {
  const SmallScene scene;
  for (const char* shard : {"2/2", "1/2"}) {
    const LimnRun run = RunLimn(scene.Arguments(TilesAnd({"--shard", shard})));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(" tiles. When all shards are"));
  }
  const LimnRun run = RunLimn(scene.Arguments(kTiles));
  EXPECT_THAT(run.out, Not(HasSubstr("drawing, tile")));
  const SmallScene in_one_go;
  ASSERT_EQ(RunLimn(in_one_go.Arguments(kTiles)).exit_code, 0);
  EXPECT_TRUE(ResultsOfRun(scene.output()) == ResultsOfRun(in_one_go.output()));
}

TEST(Tiles, RefuseWhatTakesTheWholeScene) {
  const SmallScene scene;
  for (const char* option : {"--account", "--DrawingRefinement.refine_poses"}) {
    const LimnRun run = RunLimn(scene.Arguments(TilesAnd({option, "1"})));
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr("tiles"));
  }
  EXPECT_EQ(NumFiles(scene.output()), 0u);
}

// Open MPI refuses root: as another user, in a folder that is open to all.
class MpiRun : public ::testing::Test {
 protected:
  void SetUp() override {
#ifndef LIMN_WITH_MPI
    GTEST_SKIP() << "built without MPI";
#endif
    fs::permissions(dir_.path(), fs::perms::all);
    fs::copy(LIMN_SAMPLE_DIR "/day", dir_ / "day", fs::copy_options::recursive);
    fs::create_directories(dir_ / "out");
    fs::permissions(dir_ / "out", fs::perms::all);
    dir_.WriteFile(
        "list.txt",
        "view_00.jpg\nview_01.jpg\nview_02.jpg\nview_03.jpg\nview_04.jpg\nview_05.jpg\n");
    if (RunProgram("test", {"-x", LIMN_PROGRAM}, kAsNobody).exit_code != 0) {
      GTEST_SKIP() << "the user nobody may not run " << LIMN_PROGRAM;
    }
  }

  // Open MPI leaves memory to the system when it ends, much of it by plug-ins that are unloaded by
  // then and have no name that a suppression could give.
  static std::string ThreeOf(const std::string& command) {
    const std::string no_leaks = "export ASAN_OPTIONS=$ASAN_OPTIONS:detect_leaks=0; ";
    return no_leaks + "mpirun --oversubscribe -n 3 " LIMN_PROGRAM " " + command;
  }

  // A command of the shell: the main job on the small scene, by three processes.
  std::string Command(const std::string& more = "") const {
    return ThreeOf("automatic_drawer --workspace_path ") + (dir_ / "day").string() +
           " --output_path " + (dir_ / "out").string() + " --image_list_path " +
           (dir_ / "list.txt").string() + " --quality low --max_image_size 320 --num_threads 2 " +
           more;
  }

  std::string FragmentsFolder() const { return (dir_ / "out/curves/cache/fragments").string(); }

  LimnRun RunShell(const std::string& command) const {
    return RunProgram("sh", {"-c", command}, kAsNobody);
  }

  static constexpr RunConditions kAsNobody = {.as_nobody = true};
  TempDir dir_;
};

TEST_F(MpiRun, MakesWhatOneProcessMakes) {
  const LimnRun run = RunShell(Command());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("sketches of 6 views were taken from the cache"));
  EXPECT_TRUE(ResultsOfRun(dir_ / "out") == ResultsInOneGo());
}

TEST_F(MpiRun, DrawsTilesTogether) {
  const LimnRun run = RunShell(Command("--Tiles.max_views 5 --Tiles.reach_px 20"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments(kTiles)).exit_code, 0);
  EXPECT_TRUE(ResultsOfRun(dir_ / "out") == ResultsOfRun(scene.output()));
}

TEST_F(MpiRun, AProcessThatDiesIsToldAndWhatIsFinishedIsKept) {
  const std::string cache = FragmentsFolder();
  const LimnRun killed =
      RunShell(Command() + " & mpirun=$!; until ls " + cache +
               "/*.bin >/dev/null 2>&1; do sleep 0.01; done; pkill -KILL -P $mpirun -n; "
               "wait $mpirun");
  EXPECT_NE(killed.exit_code, 0);
  EXPECT_THAT(killed.err + killed.out, HasSubstr("signal 9"));
  EXPECT_FALSE(fs::exists(dir_ / "out/drawing.json"));
  EXPECT_GE(NumFiles(cache), 1u);
  const LimnRun again = RunShell(Command());
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(ResultsOfRun(dir_ / "out") == ResultsInOneGo());
}

TEST_F(MpiRun, BadInputIsOneErrorOfOneProcess) {
  const LimnRun run = RunShell(Command("--input_path /nowhere"));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_EQ(Count("ERROR: ", run.err), 1) << run.err;
  const LimnRun viewer = RunShell(ThreeOf("drawing_viewer"));
  EXPECT_THAT(viewer.err, HasSubstr("only automatic_drawer runs in several MPI processes"));
  EXPECT_EQ(Count("ERROR: ", viewer.err), 1) << viewer.err;
}

TEST_F(MpiRun, TheOriginalSketchIsMadeOfEverybodysImageCurves) {
  const LimnRun run = RunShell(Command("--mode original"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("image curves, shard 1/3"));
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments({"--mode", "original"})).exit_code, 0);
  EXPECT_TRUE(ResultsOfRun(dir_ / "out") == ResultsOfRun(scene.output()));
}

TEST_F(MpiRun, ThatIsStoppedSaysOnceWhatIsKept) {
  // Rank 0 is the first process of mpirun; it passes the signal to nobody.
  const LimnRun run = RunShell(
      Command() + " & mpirun=$!; until ls " + FragmentsFolder() +
      "/*.bin >/dev/null 2>&1; do sleep 0.01; done; pkill -TERM -P $mpirun -o; wait $mpirun");
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(Count("Interrupted: ", run.err), 1) << run.err;
}

}  // namespace
}  // namespace limn::testing
