// SPDX-License-Identifier: BSD-3-Clause
// The work of a run in parts: shards that know nothing of each other, and tiles.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/limn_process.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/files/atomic_file.h"
#include "limn/files/output_lock.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

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
  for (const char* option : {"--account", "--refine_cameras"}) {
    const LimnRun run = RunLimn(scene.Arguments(TilesAnd({option, "1"})));
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr("tiles"));
  }
  EXPECT_EQ(NumFiles(scene.output()), 0u);
}

}  // namespace
}  // namespace limn::testing
