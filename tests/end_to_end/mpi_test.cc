// SPDX-License-Identifier: BSD-3-Clause
// MPI processes that draw together: the bytes of one process, and what is left when one of them
// fails.
#include <cstdlib>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "end_to_end/tmp_fs.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

int Count(const std::string& what, const std::string& text) {
  int count = 0;
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
  return count;
}

// What the shell of one rank does before it becomes that rank.
struct OfRank {
  int rank = -1;
  std::string commands;
};

// Runs limn in four processes.
LimnRun RunRanks(const std::vector<std::string>& arguments, const OfRank& first = {}) {
  // Open MPI leaves memory to the system when it ends, much of it by plug-ins that are unloaded by
  // then and have no name that a suppression could give.
  const std::string script =
      "export ASAN_OPTIONS=$ASAN_OPTIONS:detect_leaks=0:verify_asan_link_order=0\n"
      "if [ $OMPI_COMM_WORLD_RANK = " +
      std::to_string(first.rank) + " ]; then\n:\n" + first.commands + "\nfi\nexec \"$@\"";
  std::vector<std::string> of_mpirun = {
      "--allow-run-as-root", "--oversubscribe", "-n", "4", "sh", "-c", script, "sh", LIMN_PROGRAM};
  of_mpirun.insert(of_mpirun.end(), arguments.begin(), arguments.end());
  return RunProgram("mpirun", of_mpirun, {.max_seconds = 300});
}

const std::map<std::string, std::string>& Whole() {
  static const std::map<std::string, std::string> whole = ResultsInOneGo();
  return whole;
}

class MpiRun : public ::testing::Test {
 protected:
  void SetUp() override {
#ifndef LIMN_WITH_MPI
    GTEST_SKIP() << "built without MPI";
#endif
    if (std::system("mpirun --version > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "mpirun is not installed";
    }
  }

  // Sends a signal to a rank as soon as this many files are in a folder of the cache.
  OfRank SignalTo(int rank, const char* signal, const char* folder, int num_files) const {
    const std::string files = "ls " + (scene_ / "curves/cache" / folder).string() + "/*.bin";
    return {rank, "(until [ $(" + files + " 2> /dev/null | wc -l) -ge " +
                      std::to_string(num_files) +
                      " ]; do kill -0 $$ || exit; sleep 0.01; done; kill -" + signal + " $$) &"};
  }

  // What is there is right, and the next run continues from it to the bytes of an undisturbed one.
  void ExpectNextRunGoesOn(Leftovers allowed) const {
    EXPECT_THAT(WrongFiles(scene_.output(), Whole(), allowed), IsEmpty());
    const bool is_begun = !ReadTree(scene_ / "curves/cache/fragments").empty();
    const LimnRun again = RunRanks(scene_.Arguments());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    if (is_begun) {
      EXPECT_THAT(again.out, HasSubstr("were taken from the cache"));
    }
    EXPECT_TRUE(ResultsOfRun(scene_.output()) == Whole());
  }

  const SmallScene scene_;
};

TEST_F(MpiRun, MakesWhatOneProcessMakes) {
  const LimnRun run = RunRanks(scene_.Arguments());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("sketches of 6 views were taken from the cache"));
  EXPECT_TRUE(ResultsOfRun(scene_.output()) == Whole());
}

TEST_F(MpiRun, DrawsTilesTogether) {
  const std::vector<std::string> tiles = {"--Tiles.max_views", "5", "--Tiles.reach_px", "20"};
  const LimnRun run = RunRanks(scene_.Arguments(tiles));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments(tiles)).exit_code, 0);
  EXPECT_TRUE(ResultsOfRun(scene_.output()) == ResultsOfRun(scene.output()));
}

TEST_F(MpiRun, TheOriginalSketchIsMadeOfEverybodysImageCurves) {
  const std::vector<std::string> original = {"--mode", "original"};
  const LimnRun run = RunRanks(scene_.Arguments(original));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("image curves, shard 1/4"));
  const SmallScene scene;
  ASSERT_EQ(RunLimn(scene.Arguments(original)).exit_code, 0);
  EXPECT_TRUE(ResultsOfRun(scene_.output()) == ResultsOfRun(scene.output()));
}

TEST_F(MpiRun, BadInputIsOneErrorOfOneProcess) {
  const LimnRun run = RunRanks(scene_.Arguments({"--input_path", "/nowhere"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(Count("ERROR: ", run.err), 1) << run.err;
  const LimnRun viewer = RunRanks({"drawing_viewer"});
  EXPECT_THAT(viewer.err, HasSubstr("only automatic_drawer runs in several MPI processes"));
  EXPECT_EQ(Count("ERROR: ", viewer.err), 1) << viewer.err;
}

TEST_F(MpiRun, ThatIsStoppedSaysOnceWhatIsKept) {
  const LimnRun run = RunRanks(scene_.Arguments(), SignalTo(0, "TERM", "fragments", 1));
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(Count("Interrupted: ", run.err), 1) << run.err;
}

TEST_F(MpiRun, AProcessThatDiesIsToldAndWhatIsFinishedIsKept) {
  struct {
    int rank;
    const char* folder;
    int num_files;
  } const deaths[] = {{0, "fragments", 1},
                      {1, "fragments", 3},
                      {1, "sketch", 2},
                      {0, "sketch", 6},
                      {1, "sketch", 6}};
  for (const auto& [rank, folder, num_files] : deaths) {
    SCOPED_TRACE(std::to_string(rank) + ", " + folder + ", " + std::to_string(num_files));
    fs::remove_all(scene_.output());
    const LimnRun killed = RunRanks(scene_.Arguments(), SignalTo(rank, "KILL", folder, num_files));
    EXPECT_EQ(killed.exit_code, 128 + 9);
    const std::string died = "process rank " + std::to_string(rank) + " with PID";
    EXPECT_THAT(killed.err + killed.out, AllOf(HasSubstr(died), HasSubstr("signal 9")));
    EXPECT_GE(std::ssize(ReadTree(scene_ / "curves/cache" / folder)), num_files);
    EXPECT_FALSE(fs::exists(scene_ / "drawing.json"));
    ExpectNextRunGoesOn(Leftovers::kAll);
  }
}

// As on a host whose part of the file system is full.
TEST_F(MpiRun, AFullDiskOfOneProcessIsToldOnceWhenTheOthersAreDone) {
  if (std::system("unshare --mount mount -t tmpfs tmpfs /mnt 2> /dev/null") != 0) {
    GTEST_SKIP() << "file systems cannot be mounted here";
  }
  for (const int rank : {0, 2}) {
    fs::remove_all(scene_.output());
    const fs::path cache = scene_ / "curves/cache";
    fs::create_directories(cache);
    const LimnRun run =
        RunRanks(scene_.Arguments(),
                 {rank,
                  "exec unshare --mount sh -c 'mount -t tmpfs -o size=100k tmpfs \"$0\" && "
                  "exec \"$@\"' " +
                      cache.string() + " \"$@\""});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(HasSubstr("ERROR: rank " + std::to_string(rank) + " on "),
                               HasSubstr((cache / "fragments/view_").string()),
                               HasSubstr(": cannot write: No space left on device\n")));
    EXPECT_EQ(Count("ERROR: ", run.err), 1) << run.err;
    // Both ranks have one of the six images.
    EXPECT_EQ(ReadTree(cache).size(), 5u);
    ExpectNextRunGoesOn(Leftovers::kNone);
  }
}

TEST_F(MpiRun, AFullDiskOfAllProcessesIsToldOnce) {
  const size_t num_bytes = NumBytes(Whole());
  const TmpFs disk(scene_.output(), num_bytes);
  if (!disk.is_mounted()) GTEST_SKIP() << "file systems cannot be mounted here";
  for (const double share : {0.02, 0.3, 0.9}) {
    disk.Resize(static_cast<size_t>(share * static_cast<double>(num_bytes)));
    const LimnRun run = RunRanks(scene_.Arguments());
    EXPECT_EQ(run.exit_code, 1) << share;
    EXPECT_THAT(run.err, HasSubstr(": cannot write: No space left on device"));
    EXPECT_EQ(Count("ERROR: ", run.err), 1) << run.err;
    EXPECT_EQ(Count("Interrupted: ", run.err), 0) << run.err;
  }
  disk.Resize(size_t{1} << 30);
  ExpectNextRunGoesOn(Leftovers::kNone);
}

TEST_F(MpiRun, WithoutLocksIsRefusedOnce) {
  const LimnRun run = RunRanks(scene_.Arguments(), {0, "export LD_PRELOAD=" LIMN_NO_FLOCK});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr((scene_ / "curves/.lock").string() +
                                 ": cannot be locked: No locks available"));
  EXPECT_EQ(Count("ERROR: ", run.err), 1) << run.err;
  EXPECT_FALSE(fs::exists(scene_.output()));
  ExpectNextRunGoesOn(Leftovers::kNone);
}

}  // namespace
}  // namespace limn::testing
