// SPDX-License-Identifier: BSD-3-Clause
// Drawings that are brought up to date with new and changed images, once or while somebody watches.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/limn_process.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kSample = LIMN_SAMPLE_DIR;

constexpr int kNumImages = 24;

std::string NameOf(int image) {
  return (image < 10 ? "view_0" : "view_") + std::to_string(image) + ".jpg";
}

// Of what is believed: exports have no more.
double LengthOf(const fs::path& drawing) {
  double length = 0;
  for (const DrawingLink& link : ReadDrawingJson(drawing.string()).graph.links) {
    if (!link.tentative) length += Length(link.points_in_world);
  }
  return length;
}

// A workspace of the sample scene of which some images are used.
class UpdateTest : public ::testing::Test {
 protected:
  UpdateTest() {
    fs::create_directories(workspace());
    fs::copy(kSample / "day/sparse", workspace() / "sparse", fs::copy_options::recursive);
    fs::create_directories(workspace() / "images");
    for (int i = 0; i < kNumImages; ++i) UseImage(i, "day");
  }

  fs::path workspace() const { return dir_ / "w"; }
  fs::path out() const { return dir_ / "out"; }

  void UseImage(int number, const std::string& light) {
    const std::string name = NameOf(number);
    fs::copy_file(kSample / light / "images" / name, workspace() / "images" / name,
                  fs::copy_options::overwrite_existing);
  }

  std::vector<std::string> Arguments(int num_images, const fs::path& output,
                                     const std::vector<std::string>& more = {}) {
    std::string names;
    for (int i = 0; i < num_images; ++i) names += NameOf(i) + "\n";
    const std::string list = dir_.WriteFile("list-" + std::to_string(num_images), names);
    std::vector<std::string> arguments = {"automatic_drawer",
                                          "--workspace_path",
                                          workspace().string(),
                                          "--output_path",
                                          output.string(),
                                          "--image_list_path",
                                          list,
                                          "--quality",
                                          "low",
                                          "--max_image_size",
                                          "320"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  TempDir dir_;
};

TEST_F(UpdateTest, ANewImageIsTakenIn) {
  ASSERT_EQ(RunLimn(Arguments(kNumImages - 1, out())).exit_code, 0);
  const auto before = ReadTree(out());
  const LimnRun refused = RunLimn(Arguments(kNumImages, out()));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("is a drawing of other images"));

  const LimnRun update = RunLimn(Arguments(kNumImages, out(), {"--update", "1"}));
  ASSERT_EQ(update.exit_code, 0) << update.err;
  EXPECT_THAT(update.out, Not(HasSubstr("drawn from scratch")));
  const auto after = ReadTree(out());
  EXPECT_EQ(after.count("curves/overlays/view_23.jpg.png"), 1u);
  EXPECT_TRUE(after.at("curves/overlays/view_02.jpg.png") ==
              before.at("curves/overlays/view_02.jpg.png"));
  EXPECT_EQ(ReadDrawingJson((out() / "drawing.json").string()).metadata.view_names.size(), 24u);

  // From nothing: nearly the same, and nothing of the update is left.
  const fs::path anew = dir_ / "anew";
  ASSERT_EQ(RunLimn(Arguments(kNumImages, anew)).exit_code, 0);
  EXPECT_NEAR(LengthOf(out() / "drawing.json") / LengthOf(anew / "drawing.json"), 1, 0.1);
  ASSERT_EQ(RunLimn(Arguments(kNumImages, out())).exit_code, 0);
  EXPECT_TRUE(ReadTree(out()).at("drawing.json") == ReadTree(anew).at("drawing.json"));
}

TEST_F(UpdateTest, WithoutChangesTheResultsAreTheSame) {
  ASSERT_EQ(RunLimn(Arguments(6, out(), {"--update", "1"})).exit_code, 0);
  const auto first = ReadTree(out());
  ASSERT_EQ(RunLimn(Arguments(6, out(), {"--update", "1"})).exit_code, 0);
  const auto again = ReadTree(out());
  for (const char* name : {"drawing.ply", "drawing.obj", "curves/tracks.txt",
                           "curves/swept-sketch.bin", "curves/overlays/view_03.jpg.png"}) {
    EXPECT_TRUE(first.at(name) == again.at(name)) << name;
  }
}

TEST_F(UpdateTest, WhatCannotBeUpdatedIsSaid) {
  const auto error = [&](const std::vector<std::string>& options) {
    const LimnRun run = RunLimn(Arguments(6, out(), options));
    EXPECT_EQ(run.exit_code, 1);
    return run.err;
  };
  EXPECT_THAT(error({"--update", "1", "--account", "1"}), HasSubstr("account = 1"));
  EXPECT_THAT(error({"--watch", "1", "--regularize", "1"}), HasSubstr("regularize = 1"));
  EXPECT_THAT(error({"--watch", "1", "--shard", "1/2"}), HasSubstr("watch = 1"));
  EXPECT_FALSE(fs::exists(out()));
  const LimnRun first = RunLimn(Arguments(6, out(), {"--update", "1"}));
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_THAT(first.out, HasSubstr("drawn from scratch: there is no drawing"));
}

TEST_F(UpdateTest, AWatchedWorkspaceIsDrawnWhenItChanges) {
  LimnProcess run(Arguments(kNumImages, out(), {"--watch", "1"}));
  const fs::path last = out() / "curves/project.ini";
  const auto wait_for_drawing = [&] {
    run.WaitUntil([&] { return fs::exists(last); });
    fs::remove(last);  // written at the end of every drawing
  };
  wait_for_drawing();
  const std::string before = ReadTree(out()).at("drawing.json");
  UseImage(3, "evening");
  wait_for_drawing();
  EXPECT_FALSE(ReadTree(out()).at("drawing.json") == before);
  // A model may be half written: that must not end the run.
  const fs::path model = workspace() / "sparse/images.bin";
  fs::rename(model, dir_ / "images.bin");
  std::this_thread::sleep_for(std::chrono::seconds(5));
  fs::rename(dir_ / "images.bin", model);
  wait_for_drawing();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  run.Signal(SIGINT);
  const LimnProcess::End end = run.Wait();
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("ERROR: "));
  EXPECT_THAT(end.out, HasSubstr("Waiting for changes"));
}

}  // namespace
}  // namespace limn::testing
