// SPDX-License-Identifier: BSD-3-Clause
// What is found in the output folder: results of earlier runs, other runs, no room, no permission.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "end_to_end/limn_process.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "end_to_end/tmp_fs.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::map<std::string, std::string> RunWhole(const SmallScene& scene) {
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return Results(scene.output());
}

std::string Read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void Write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// The lines that contain a text.
std::vector<std::string> Lines(const std::string& text, const std::string& part) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.find(part) != std::string::npos) lines.push_back(line);
  }
  return lines;
}

TEST(OutputFolder, BadCachedResultsAreMadeAgainAndThatIsSaid) {
  const SmallScene scene;
  const auto whole = RunWhole(scene);
  const fs::path fragments = scene / "curves/cache/fragments";
  const fs::path sketches = scene / "curves/cache/sketch";
  const auto spoil = [](const fs::path& path, size_t at, char byte) {
    std::string bytes = Read(path);
    ASSERT_LT(at, bytes.size());
    bytes[at] = byte;
    Write(path, bytes);
  };
  fs::resize_file(fragments / "view_00.jpg.bin", 1000);  // cut
  fs::resize_file(fragments / "view_01.jpg.bin", 0);     // empty
  spoil(fragments / "view_02.jpg.bin", 2000, 'x');       // a wrong byte
  spoil(fragments / "view_03.jpg.bin", 8, 99);           // of a later version
  fs::copy_file(sketches / "view_04.jpg.bin", fragments / "view_04.jpg.bin",
                fs::copy_options::overwrite_existing);  // of another stage
  fs::copy_file(sketches / "view_00.jpg.bin", sketches / "view_01.jpg.bin",
                fs::copy_options::overwrite_existing);  // of another view
  Write(sketches / "view_02.jpg.bin", "a text");
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(
      Lines(run.out, "image curves of"),
      ::testing::ElementsAre(
          EndsWith("image curves of 1 images were taken from the cache"),
          AllOf(HasSubstr("image curves of 5 images in the cache could not be used and were made "
                          "again: 1 made with other options, images or cameras"),
                HasSubstr("4 damaged (" + (fragments / "view_00.jpg.bin").string() + ": byte "))));
  EXPECT_THAT(Lines(run.out, "sketches of"),
              ::testing::ElementsAre(
                  EndsWith("sketches of 4 views were taken from the cache"),
                  AllOf(HasSubstr("sketches of 2 views in the cache could not be used"),
                        HasSubstr("1 made with other"), HasSubstr("view_02.jpg.bin: "))));
  EXPECT_TRUE(Results(scene.output()) == whole);
}

TEST(OutputFolder, FilesThatTheCacheCannotReadOrReplaceDoNotStopARun) {
  const SmallScene scene;
  auto whole = RunWhole(scene);
  const fs::path file = scene / "curves/cache/sketch/view_03.jpg.bin";
  fs::remove(file);
  fs::create_directories(file / "sub");
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(file.string() + ": is a folder, not a file"));
  EXPECT_THAT(Lines(run.out, "WARNING: "),
              ::testing::ElementsAre(AllOf(HasSubstr(
                  "sketches of 1 views are not kept for another run: " + file.string()))));
  whole.erase("curves/cache/sketch/view_03.jpg.bin");
  EXPECT_TRUE(Results(scene.output()) == whole);
}

TEST(OutputFolder, FilesThatAreNotOursStayAndAreFoundBeforeWorkStarts) {
  const SmallScene scene;
  for (const char* name : {"drawing.ply", "drawing.html", "curves/tracks.txt"}) {
    fs::create_directories((scene / name).parent_path());
    Write(scene / name, "mine");
    const LimnRun run = RunLimn(scene.Arguments());
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err, "ERROR: " + (scene / name).string() +
                           ": exists, and was not made by limn: --overwrite 1 replaces it\n");
    EXPECT_EQ(ReadTree(scene.output()), (std::map<std::string, std::string>{{name, "mine"}}));
    fs::remove(scene / name);
  }
  for (const char* name : {"curves/overlays/view_03.jpg.png", "curves/swept-sketch.bin"}) {
    fs::create_directories(scene / name);
    const LimnRun run = RunLimn(scene.Arguments());
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err,
              "ERROR: " + (scene / name).string() + ": cannot write: is a folder, not a file\n");
    EXPECT_THAT(ReadTree(scene.output()), IsEmpty());
    fs::remove(scene / name);
  }
}

// Others, at every depth, are tested by tests/hostile/output_links.py.
TEST(OutputFolder, LinksInItLeadNothingElsewhere) {
  const SmallScene scene;
  const TempDir pictures;
  Write(pictures / "view_03.jpg.png", "mine");
  fs::create_directories(scene / "curves");
  fs::create_directory_symlink(pictures.path(), scene / "curves/overlays");
  const LimnRun run = RunLimn(scene.Arguments({"--overwrite", "1"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith("ERROR: " + (scene / "curves/overlays").string() +
                                  ": is a link to " + pictures.path().string() + ", and nothing"));
  EXPECT_EQ(ReadTree(pictures.path()),
            (std::map<std::string, std::string>{{"view_03.jpg.png", "mine"}}));
}

TEST(OutputFolder, ASketchReplacesOnlySketches) {
  const SmallScene scene;
  const fs::path sketch = scene / "curves/swept-sketch.ply";
  const auto run_sketcher = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"curve_sketcher",
                                          "--workspace_path",
                                          LIMN_SAMPLE_DIR "/day",
                                          "--output_path",
                                          scene.output().string(),
                                          "--max_image_size",
                                          "160"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  };
  const auto expect_refusal = [&](const std::string& reason) {
    const LimnRun run = run_sketcher({});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err, "ERROR: " + sketch.string() + ": " + reason + "\n");
    EXPECT_FALSE(fs::exists(scene / "curves/cache"));
  };
  fs::create_directories(sketch);
  expect_refusal("cannot write: is a folder, not a file");
  fs::remove(sketch);
  Write(sketch, "mine");
  expect_refusal("exists, and was not made by limn: --overwrite 1 replaces it");
  EXPECT_EQ(Read(sketch), "mine");
  EXPECT_EQ(run_sketcher({"--overwrite", "1"}).exit_code, 0);
  EXPECT_EQ(run_sketcher({}).exit_code, 0);
  EXPECT_NE(Read(sketch), "mine");
}

TEST(OutputFolder, OnlyWhatAnOptionTouchesIsMadeAgain) {
  const SmallScene scene;
  RunWhole(scene);
  const LimnRun run =
      RunLimn(scene.Arguments({"--Sketch.min_supporting_views", "4", "--overwrite", "1"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("image curves of 6 images were taken from the cache"));
  EXPECT_THAT(Lines(run.out, "sketches of"),
              ::testing::ElementsAre(HasSubstr("6 made with other options")));
}

// A file that is opened while standard output is closed gets its number.
TEST(OutputFolder, WithClosedStreamsNothingIsPrintedIntoResults) {
  const SmallScene scene;
  const auto whole = RunWhole(scene);
  for (const char* closed : {"exec \"$@\" >&-", "exec \"$@\" <&- >&- 2>&-"}) {
    fs::remove_all(scene.output());
    std::vector<std::string> arguments = {"-c", closed, "sh", LIMN_PROGRAM};
    for (const std::string& argument : scene.Arguments()) arguments.push_back(argument);
    EXPECT_EQ(RunProgram("/bin/sh", arguments).exit_code, 0);
    EXPECT_TRUE(Results(scene.output()) == whole) << closed;
  }
}

TEST(OutputFolder, ASecondRunIsRefusedUntilTheFirstHasEnded) {
  const SmallScene scene;
  LimnProcess first(scene.Arguments());
  const fs::path lock = scene / "curves/.lock";
  first.WaitUntil([&] { return !Read(lock).empty(); });
  // It must not end before the others have been refused.
  first.Signal(SIGSTOP);
  for (const char* command : {"automatic_drawer", "curve_linker", "drawing_viewer"}) {
    const LimnRun second = RunLimn({command, "--workspace_path", LIMN_SAMPLE_DIR "/day",
                                    "--output_path", scene.output().string()});
    EXPECT_EQ(second.exit_code, 1) << command;
    EXPECT_THAT(second.err, AllOf(StartsWith("ERROR: " + lock.string() + ": "),
                                  HasSubstr("process " + std::to_string(first.pid()))));
    EXPECT_EQ(std::count(second.err.begin(), second.err.end(), '\n'), 1);
  }
  first.Signal(SIGKILL);
  first.Wait();
  EXPECT_TRUE(fs::exists(lock));
  const LimnRun third = RunLimn(scene.Arguments());
  EXPECT_EQ(third.exit_code, 0) << third.err;
  EXPECT_FALSE(fs::exists(lock));
}

TEST(OutputFolder, AFullDiskEndsARunWithALineAndLosesNothing) {
  const SmallScene scene;
  const auto whole = RunWhole(scene);
  fs::remove_all(scene.output());
  const TmpFs disk(scene.output(), 1);
  if (!disk.is_mounted()) GTEST_SKIP() << "file systems cannot be mounted here";
  for (const double share : {0.05, 0.5, 0.8, 0.95}) {
    disk.Resize(static_cast<size_t>(share * static_cast<double>(NumBytes(whole))));
    const LimnRun run = RunLimn(scene.Arguments());
    EXPECT_EQ(run.exit_code, 1) << share;
    EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: " + scene.output().string()),
                               HasSubstr(": cannot write: No space left on device")));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(WrongFiles(scene.output(), whole, Leftovers::kNone), IsEmpty()) << share;
  }
  disk.Resize(size_t{1} << 30);
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(Results(scene.output()) == whole);
}

TEST(OutputFolder, ALimitOnFileSizesEndsARunWithALine) {
  const SmallScene scene;
  std::vector<std::string> arguments = {"-c", "ulimit -f 40; exec \"$@\"", "sh", LIMN_PROGRAM};
  for (const std::string& argument : scene.Arguments()) arguments.push_back(argument);
  const LimnRun run = RunProgram("/bin/sh", arguments);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: " + scene.output().string()),
                             HasSubstr(": cannot write: File too large")));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

TEST(OutputFolder, WithoutLocksARunIsRefusedAndLeavesNothing) {
  const SmallScene scene;
  std::vector<std::string> arguments = {"LD_PRELOAD=" LIMN_NO_FLOCK,
                                        "ASAN_OPTIONS=verify_asan_link_order=0", LIMN_PROGRAM};
  for (const std::string& argument : scene.Arguments()) arguments.push_back(argument);
  const auto expect_refusal = [&] {
    const LimnRun run = RunProgram("env", arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err, "ERROR: " + (scene / "curves/.lock").string() +
                           ": cannot be locked: No locks available: choose an --output_path on a "
                           "file system with flock\n");
  };
  expect_refusal();
  EXPECT_FALSE(fs::exists(scene.output()));
  fs::create_directories(scene / "curves");
  expect_refusal();
  EXPECT_TRUE(fs::is_empty(scene / "curves"));
  std::ofstream(scene / "curves/.lock") << "process 1 on another host";
  expect_refusal();
  EXPECT_EQ(Read(scene / "curves/.lock"), "process 1 on another host");
}

TEST(OutputFolder, PathsNeedNotBeUtf8) {
  const SmallScene scene;
  const auto whole = RunWhole(scene);
  std::vector<std::string> arguments = scene.Arguments();
  const fs::path output = scene.output() /
                          "Fl\xE4"
                          "che";
  std::replace(arguments.begin(), arguments.end(), scene.output().string(), output.string());
  const LimnRun run = RunLimn(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(output / "drawing.html"));
  auto results = Results(output);
  EXPECT_NE(results["curves/project.ini"], "");
  EXPECT_EQ(results["drawing.json"], whole.at("drawing.json"));
}

TEST(OutputFolder, ACacheWithoutRoomDoesNotLoseTheRun) {
  const SmallScene scene;
  auto whole = RunWhole(scene);
  fs::remove_all(scene.output());
  const TmpFs disk(scene / "curves/cache", 1 << 12);
  if (!disk.is_mounted()) GTEST_SKIP() << "file systems cannot be mounted here";
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Lines(run.out, "WARNING: "),
              ::testing::ElementsAre(AllOf(HasSubstr("image curves of 6 images are not kept"),
                                           HasSubstr("No space left on device")),
                                     AllOf(HasSubstr("sketches of 6 views are not kept"),
                                           HasSubstr("No space left on device")),
                                     AllOf(HasSubstr("drawings of 1 scenes are not kept"),
                                           HasSubstr("No space left on device"))));
  std::erase_if(whole, [](const auto& file) { return file.first.starts_with("curves/cache/"); });
  EXPECT_TRUE(Results(scene.output()) == whole);
}

// A workspace that belongs to another user.
TEST(OutputFolder, AReadOnlyWorkspaceIsRefusedBeforeWorkStarts) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  const TempDir dir;
  fs::copy(LIMN_SAMPLE_DIR "/day", dir / "day", fs::copy_options::recursive);
  fs::create_directories(dir / "mine");
  fs::permissions(dir / "mine", fs::perms::all);
  const RunConditions as_nobody = {.as_nobody = true};
  if (RunProgram("test", {"-x", LIMN_PROGRAM}, as_nobody).exit_code != 0) {
    GTEST_SKIP() << "the user nobody may not run " << LIMN_PROGRAM;
  }
  const std::vector<std::string> arguments = {"curve_linker", "--workspace_path",
                                              (dir / "day").string(), "--max_image_size", "160"};
  const LimnRun refused = RunLimn(arguments, as_nobody);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("results cannot be written here"),
                                 HasSubstr("choose another --output_path")));
  EXPECT_THAT(refused.out, Not(HasSubstr("3D points")));  // before the model is read
  std::vector<std::string> elsewhere = arguments;
  elsewhere.insert(elsewhere.end(), {"--output_path", (dir / "mine").string()});
  const LimnRun run = RunLimn(elsewhere, as_nobody);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(dir / "mine/curves/cache/fragments/view_00.jpg.bin"));
}

}  // namespace
}  // namespace limn::testing
